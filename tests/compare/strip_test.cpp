#include "compare/strips/strip.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>
#include <span>

#include "compare/strips/dispatch.h"
#include "compare/strips/runs.h"

namespace zproof {
namespace {

/// Runs of one to thirty pixels of a few ids, the largest and none among them.
void show_runs(std::mt19937& random, Strip::Values<PrimitiveId>& shown) {
    const std::array ids{PrimitiveId{0}, PrimitiveId{1}, PrimitiveId{UINT32_MAX - 1}, PrimitiveId::none};
    const std::uint32_t longest = 1 + std::uint32_t(random() % 30);
    for (std::size_t i = 0; i < shown.size(); ++i)
        shown[i] = i > 0 && random() % longest != 0 ? shown[i - 1] : ids[random() % ids.size()];
}

/// Calls visit with random strips whose ids were compared.
template <class Visit>
void for_each_strip(const Visit& visit) {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        Strip::Values<PrimitiveId> ours;
        show_runs(random, ours);
        Strip::Values<PrimitiveId> theirs = ours;
        if (round % 2 != 0) show_runs(random, theirs);
        if (round % 4 == 2) theirs[random() % Strip::width] = PrimitiveId{7};
        Strip strip{};
        strip.candidate.primitive = ours.data();
        strip.reference.primitive = theirs.data();
        const strips::Ids ids = strips::widest_kernel().compare(ours.data(), theirs.data());
        strip.turns = ids.turns, strip.differ = ids.differ;
        visit(strip);
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(StripKernels, SayWhereIdsTurnAndDiffer) {
    for_each_strip([](const Strip& strip) {
        const PrimitiveId *const ours = strip.candidate.primitive, *const theirs = strip.reference.primitive;
        for (const strips::Kernel& kernel : strips::available_kernels()) {
            SCOPED_TRACE(kernel.name);
            const auto [turns, differ, runs] = kernel.compare(ours, theirs);
            ASSERT_EQ(runs, std::popcount(turns));
            for (std::size_t i = 0; i < Strip::width; ++i) {
                ASSERT_EQ((turns >> i & 1) != 0, i == 0 || ours[i] != ours[i - 1]) << i;
                ASSERT_EQ((differ >> i & 1) != 0, ours[i] != theirs[i]) << i;
                ASSERT_EQ((kernel.where_shown(theirs, ours[9]) >> i & 1) != 0, theirs[i] == ours[9]) << i;
            }
        }
    });
}

TEST(Strip, HasTheLawsOfItsRunsAndOfWhatDiffers) {
    for_each_strip([](Strip strip) {
        for (std::size_t i = 0; i < Strip::width; ++i) strip.law_of_run[i] = std::uint32_t(100 + i);
        Strip::Pixels even = 0x5555'5555'5555'5555 & strip.differ, odd = strip.differ & ~even;
        for (const Strip::Pixels some : {even, odd})
            if (some != 0)
                strip.others.of[std::size_t(strip.others.count++)] = {some == even ? 200u : 201u, some};
        const LawsAlong laws = laws_along(strip);
        std::uint32_t run = 99;
        for (std::size_t i = 0; i < Strip::width; ++i) {
            run += std::uint32_t(strip.turns >> i & 1);
            ASSERT_EQ(laws.candidate[i], run) << i;
            ASSERT_EQ(laws.reference[i], (strip.differ >> i & 1) != 0 ? 200 + i % 2 : run) << i;
        }
    });
}

TEST(Strip, TellsWhatTheCandidateShowsWhereTheyDiffer) {
    for_each_strip([](Strip strip) {
        for (std::size_t i = 0; i < Strip::width; ++i) strip.law_of_run[i] = std::uint32_t(100 + i);
        const LawsAlong laws = laws_along(strip);
        const Strip::ShownOnes shown = candidates_where_they_differ(strip);
        Strip::Pixels told = 0;
        for (const auto& [law, pixels] : std::span(shown.of.data(), std::size_t(shown.count))) {
            ASSERT_NE(pixels, 0u);
            ASSERT_EQ(told & pixels, 0u);
            told |= pixels;
            for (std::size_t i = 0; i < Strip::width; ++i)
                ASSERT_TRUE((pixels >> i & 1) == 0 || law == laws.candidate[i]) << i;
        }
        ASSERT_EQ(told, strip.differ);
    });
}

TEST(Runs, AreFilledWithWhatTheirFirstPixelGives) {
    for_each_strip([](const Strip& strip) {
        std::size_t asked = 0;
        SpreadValues<std::uint32_t, Strip::width> values;
        spread_over_runs<Strip::width>(
            strip.turns, [&](std::size_t first) { return ++asked, std::uint32_t(100 + first); }, values);
        ASSERT_EQ(asked, std::size_t(std::popcount(strip.turns)));
        std::uint32_t expected = 0;
        for (std::size_t i = 0; i < Strip::width; ++i) {
            if ((strip.turns >> i & 1) != 0) expected = std::uint32_t(100 + i);
            ASSERT_EQ(values[i], expected) << i;
        }
    });
}

TEST(Runs, EndWithTheChunkThatTheyAreSpreadOver) {
    for (std::uint32_t turns = 1; turns < 1u << tile_columns; turns += 2) {
        SpreadValues<int, tile_columns> values;
        spread_over_runs<tile_columns>(
            turns, [](std::size_t first) { return int(first); }, values);
        for (int i = 0, first = 0; i < int(tile_columns); ++i) {
            if ((turns >> i & 1) != 0) first = i;
            ASSERT_EQ(values[std::size_t(i)], first);
        }
    }
}

}  // namespace
}  // namespace zproof
