// The filters' table at full size: 3 GB and some seconds, so it is labelled slow.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "filters/stored/summed_area.h"

namespace zproof::texture {
namespace {

constexpr int side = 8192;
constexpr float step = 0x1p-24f;
using Whole = glm::vec<4, std::int64_t>;

/// Multiples of 2^-24 below 1, four from one throw.
glm::vec4 texel_of(std::uint32_t bits) {
    const auto mixed = std::uint32_t(bits * 0x9E3779B9u);
    return step * glm::vec4(float(bits >> 8), float(~bits >> 8), float(mixed >> 8), float(bits & 0xFFFFFF));
}

TEST(SummedAreaFull, Of8192SquaredEqualsBruteForceBitByBit) {
    LinearImage image{side, side, {}};
    image.texels.reserve(std::size_t{side} * side);
    std::mt19937 rng(29);
    for (std::size_t i = 0; i < std::size_t{side} * side; ++i)
        image.texels.push_back(texel_of(std::uint32_t(rng())));
    const SummedArea table(image, SatStorage::integer);
    std::vector<Whole> columns(side, Whole(0));
    for (int row = 0; row < side; ++row) {
        Whole running(0);
        for (int column = 0; column < side; ++column) {
            running += columns[std::size_t(column)] += Whole(image.at(column, row) / step);
            ASSERT_EQ(table.sum({0, column + 1, 1}, {0, row + 1, 1}), glm::dvec4(running) * double(step))
                << column << ", " << row;
        }
    }
    for (int at = 0; at < side; at += 61)  // and back again: boxes of one texel
        ASSERT_EQ(table.sum({at, at + 1, 1}, {side - at - 1, side - at, 1}),
                  glm::dvec4(image.at(at, side - at - 1)));
}

}  // namespace
}  // namespace zproof::texture
