#include "compare/search/by_triangle.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace zproof {
namespace {

TEST(ByTriangle, MakesEachOnceAndLeavesItWhereItIs) {
    std::mt19937 random(1);
    std::map<std::uint32_t, const std::uint64_t*> known;
    ByTriangle<std::uint64_t> squares;
    int made = 0;
    const auto ask = [&](std::uint32_t triangle) {
        return &squares(triangle, [&] { return ++made, std::uint64_t{triangle} * triangle; });
    };
    for (int i = 0; i < 20'000; ++i) {
        const std::uint32_t triangle = i == 0   ? 0
                                       : i == 1 ? UINT32_MAX
                                       : i % 2  ? std::uint32_t(random())
                                                : std::uint32_t(random() % 4096) << 16;
        const auto [place, is_new] = known.try_emplace(triangle, nullptr);
        if (is_new) place->second = ask(triangle);
        ASSERT_EQ(ask(triangle), place->second);
    }
    EXPECT_EQ(std::size_t(made), known.size());
    for (const auto& [triangle, square] : known) {
        ASSERT_EQ(ask(triangle), square);
        ASSERT_EQ(*square, std::uint64_t{triangle} * triangle);
    }
}

TEST(ByTriangle, MakesAllAnewOnceItHasForgotten) {
    const auto value = [](std::uint64_t triangle, std::uint64_t round) { return 10 * triangle + round + 1; };
    ByTriangle<std::uint64_t> rounds;
    for (std::uint64_t round = 0; round < 3; ++round) {
        for (std::uint32_t triangle = 0; triangle < 1000 + round * 50'000; ++triangle)
            ASSERT_EQ(rounds(triangle, [&] { return value(triangle, round); }), value(triangle, round));
        EXPECT_EQ(rounds.count(), 1000 + round * 50'000);
        for (const std::uint32_t triangle : {0u, 31u, 32u, 999u})
            ASSERT_EQ(rounds(triangle, [] { return std::uint64_t{0}; }), value(triangle, round));
        rounds.forget();
        EXPECT_EQ(rounds.count(), 0u);
    }
}

}  // namespace
}  // namespace zproof
