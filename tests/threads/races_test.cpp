// ThreadSanitizer sees the races of loops over the stand-in for TBB, and reports none where there is none.
// Each loop runs in a process of its own, which ThreadSanitizer ends with 66 where it has reported something.
#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>

#include <cstdlib>
#include <functional>
#include <numeric>
#include <vector>

#include "math/bulk.h"

namespace {

constexpr int many = 64;
constexpr int reported = 66, silent = 0;

class Races : public testing::Test {
  protected:
    Races() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

template <typename Loop>
[[noreturn]] void run_alone(const Loop& loop) {
    loop();
    std::exit(silent);
}

TEST_F(Races, OfBodiesAreReported) {
    int shared = 0;
    const auto loop = [&] { tbb::parallel_for(0, many, [&](int) { ++shared; }); };
    EXPECT_EXIT(run_alone(loop), testing::ExitedWithCode(reported), "data race");
}

TEST_F(Races, OfTwoIndicesAreReported) {
    int shared = 0;
    const auto loop = [&] { tbb::parallel_for(0, 2, [&](int) { ++shared; }); };
    EXPECT_EXIT(run_alone(loop), testing::ExitedWithCode(reported), "data race");
}

TEST_F(Races, OfBodiesWithElementsOfTheirOwnAreReported) {
    int shared = 0;
    tbb::enumerable_thread_specific<int> counts;
    const auto loop = [&] {
        tbb::parallel_for(0, many, [&](int) {
            ++counts.local();
            ++shared;
            ++counts.local();
        });
    };
    EXPECT_EXIT(run_alone(loop), testing::ExitedWithCode(reported), "data race");
}

TEST_F(Races, OfNestedLoopsAreReported) {
    std::vector<int> shared(many);
    const auto loop = [&] {
        tbb::parallel_for(0, many, [&](int) {
            tbb::parallel_for(std::size_t{0}, shared.size(), [&](std::size_t j) { ++shared[j]; });
        });
    };
    EXPECT_EXIT(run_alone(loop), testing::ExitedWithCode(reported), "data race");
}

TEST_F(Races, OfReductionsAreReported) {
    int shared = 0;
    const auto loop = [&] {
        return tbb::parallel_reduce(
            tbb::blocked_range<int>(0, many), 0, [&](const auto&, int sum) { return sum + ++shared; },
            std::plus{});
    };
    EXPECT_EXIT(run_alone(loop), testing::ExitedWithCode(reported), "data race");
}

TEST_F(Races, OfOrdersAreReported) {
    int shared = 0;
    std::vector<int> numbers(many);
    const auto loop = [&] { tbb::parallel_sort(numbers, [&](int a, int b) { return ++shared, a < b; }); };
    EXPECT_EXIT(run_alone(loop), testing::ExitedWithCode(reported), "data race");
}

TEST_F(Races, AreNotReportedBetweenALoopAndWhatComesBeforeAndAfter) {
    const auto loops = [] {
        std::vector<int> numbers(many, 1);
        tbb::enumerable_thread_specific<int> counts;
        for (int times = 0; times < 20; ++times)
            tbb::parallel_for(std::size_t{0}, numbers.size(),
                              [&](std::size_t i) { counts.local() += numbers[i]++; });
        return std::accumulate(counts.begin(), counts.end(), 0);
    };
    EXPECT_EXIT(run_alone(loops), testing::ExitedWithCode(silent), "");
}

/// libtbbmalloc is not instrumented either.
TEST_F(Races, AreNotReportedWhereMemoryChangesHands) {
    const auto loop = [] {
        tbb::parallel_for(0, many, [](int i) { zproof::Bulk<int> numbers(std::size_t{1} << 17, i); });
    };
    EXPECT_EXIT(run_alone(loop), testing::ExitedWithCode(silent), "");
}

}  // namespace
