#include "scenes/vector_block.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace zproof {
namespace {

std::array<std::uint32_t, 3> bits(const glm::vec3& v) {
    return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
            std::bit_cast<std::uint32_t>(v.z)};
}

/// Seeded; every third has a zero of either sign, some are tiny and some huge.
std::vector<glm::dvec3> assorted(std::size_t count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> digit(-1, 1), exponent(-30, 30);
    std::vector<glm::dvec3> vectors;
    for (std::size_t i = 0; i < count; ++i) {
        const double scale = std::exp2(exponent(random));
        vectors.emplace_back(digit(random) * scale, i % 3 == 0 ? -0.0 : digit(random), digit(random) / scale);
    }
    return vectors;
}

/// What becomes of the vectors in blocks, beside what becomes of each alone.
template <typename InBlock, typename Alone>
void expect_same_bits(const std::vector<glm::dvec3>& vectors, const InBlock& in_block, const Alone& alone) {
    ASSERT_LE(vectors.size(), VectorBlock::capacity);
    VectorBlock block(vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) block.set(i, vectors[i]);
    in_block(block);
    std::vector<glm::vec3> found(vectors.size());
    block.write(found);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        ASSERT_EQ(bits(found[i]), bits(glm::vec3(alone(vectors[i])))) << "vector " << i;
}

TEST(VectorBlock, TransformsAsGlmDoes) {
    const glm::dmat3 matrix(0.1, -3, 1e5, 0, 1. / 3, -1e-7, 7, -0.0, 0.3);
    const glm::dvec3 translation(0.1, -1e7, 0);
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, VectorBlock::capacity})
        expect_same_bits(
            assorted(size),
            [&](VectorBlock& block) {
                block.multiply(matrix);
                block.add(translation);
            },
            [&](const glm::dvec3& v) { return matrix * v + translation; });
}

TEST(VectorBlock, ReadsFloatsThatLieAnywhere) {
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, VectorBlock::capacity}) {
        std::vector<glm::vec3> floats;
        for (const glm::dvec3& v : assorted(size)) floats.emplace_back(v);
        std::vector<unsigned char> bytes(1 + size * sizeof(glm::vec3));
        std::memcpy(bytes.data() + 1, floats.data(), size * sizeof(glm::vec3));
        VectorBlock block(size);
        block.read(bytes.data() + 1);
        std::vector<glm::vec3> found(size);
        block.write(found);
        for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(bits(found[i]), bits(floats[i])) << "vector " << i;
    }
}

TEST(VectorBlock, NormalizesAsGlmDoesAndKeepsSigns) {
    expect_same_bits(
        assorted(VectorBlock::capacity), [](VectorBlock& block) { block.normalize(); },
        [](const glm::dvec3& v) { return v / glm::length(v); });
}

TEST(VectorBlock, GivesNoDirectionToWhatHasNone) {
    constexpr double huge = std::numeric_limits<double>::max(), infinite = INFINITY;
    const std::vector<glm::dvec3> without{
        {0, 0, 0}, {-0.0, -0.0, -0.0}, {huge, huge, 0}, {infinite, 0, 0}, {0, -NAN, 1}};
    expect_same_bits(
        without, [](VectorBlock& block) { block.normalize(); },
        [](const glm::dvec3&) { return glm::dvec3(0); });
}

}  // namespace
}  // namespace zproof
