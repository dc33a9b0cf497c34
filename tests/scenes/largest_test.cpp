#include "scenes/largest.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

namespace zproof {
namespace {

constexpr std::uint32_t every_bit = 0xFFFF'FFFF;

template <typename T>
const unsigned char* bytes_of(const std::vector<T>& numbers) {
    return reinterpret_cast<const unsigned char*>(numbers.data());
}

TEST(Largest, FindsItWhereverItStands) {
    for (const std::size_t count : {1u, 15u, 16u, 17u, 100u})
        for (std::size_t at = 0; at < count; ++at) {
            std::vector<std::uint32_t> wide(count, 3);
            std::vector<std::uint16_t> narrow(count, 3);
            wide[at] = 0xFFFF'FFFE;
            narrow[at] = 0xFFFE;
            ASSERT_EQ(largest(bytes_of(wide), count, every_bit), 0xFFFF'FFFE) << at << " of " << count;
            ASSERT_EQ(largest(bytes_of(narrow), count, std::uint16_t(every_bit)), 0xFFFE)
                << at << " of " << count;
        }
}

TEST(Largest, OfNothingIsZero) { EXPECT_EQ(largest(nullptr, 0, every_bit), 0u); }

TEST(Largest, TellsWhatIsNotFinite) {
    const auto is_finite = [](float value) {
        const std::vector<float> numbers{-1, 0, value, 1e38f};
        return largest(bytes_of(numbers), numbers.size(), magnitude_bits) < infinite_bits;
    };
    for (const float value : {0.f, -0.f, 3.4e38f, -3.4e38f, 1e-45f}) EXPECT_TRUE(is_finite(value)) << value;
    for (const float value : {INFINITY, -INFINITY, NAN, -NAN, std::bit_cast<float>(0x7F80'0001)})
        EXPECT_FALSE(is_finite(value)) << value;
}

}  // namespace
}  // namespace zproof
