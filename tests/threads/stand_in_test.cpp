// tests/threads/tbb does what TBB promises, on several threads.
#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr int many = 200;

std::size_t threads_of_loop() {
    std::vector<std::thread::id> ran_on(many);
    tbb::parallel_for(0, many, [&](int i) { ran_on[std::size_t(i)] = std::this_thread::get_id(); });
    return std::set(ran_on.begin(), ran_on.end()).size();
}

TEST(StandIn, LoopRunsOnAsManyThreadsAsTheArenaHas) {
    EXPECT_EQ(threads_of_loop(), 4u);
    EXPECT_EQ(tbb::task_arena(1).execute(threads_of_loop), 1u);
    EXPECT_EQ(tbb::task_arena(3).execute(threads_of_loop), 3u);
    EXPECT_EQ(threads_of_loop(), 4u);
}

TEST(StandIn, NestedLoopsVisitEveryIndexOnceOnTheThreadsOfTheArena) {
    std::vector<std::vector<int>> visits(9, std::vector<int>(7));
    std::vector<int> allowed(9);
    tbb::task_arena(2).execute([&] {
        tbb::parallel_for(std::size_t{0}, visits.size(), [&](std::size_t i) {
            allowed[i] = tbb::this_task_arena::max_concurrency();
            tbb::parallel_for(std::size_t{0}, visits[i].size(), [&](std::size_t j) { ++visits[i][j]; });
        });
    });
    EXPECT_EQ(visits, std::vector(9, std::vector<int>(7, 1)));
    EXPECT_EQ(allowed, std::vector<int>(9, 2));
}

TEST(StandIn, RangeIsCutIntoPiecesOfItsGrainSize) {
    std::vector<std::size_t> piece_of(23);
    const tbb::blocked_range<std::size_t> all(0, piece_of.size(), 10);
    tbb::parallel_for(all, [&](const auto& some) {
        for (std::size_t i = some.begin(); i != some.end(); ++i) piece_of[i] += some.size();
    });
    std::vector<std::size_t> expected(23, 10);
    std::fill(expected.begin() + 20, expected.end(), 3);
    EXPECT_EQ(piece_of, expected);
}

TEST(StandIn, EmptyLoopsDoNothing) {
    const auto fail = [](const auto&) { ADD_FAILURE(); };
    tbb::parallel_for(3, 3, fail);
    tbb::parallel_for(3, 1, fail);
    tbb::parallel_for(tbb::blocked_range<int>(5, 5), fail);
}

TEST(StandIn, ReductionKeepsTheOrder) {
    const std::string letters = "the order of the letters";
    const std::string copy = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, letters.size()), std::string(),
        [&](const auto& some, std::string sum) { return sum + letters.substr(some.begin(), some.size()); },
        std::plus{});
    EXPECT_EQ(copy, letters);
}

TEST(StandIn, SortsBothHalvesAndMergesThem) {
    std::vector<int> numbers;
    for (int i = 0; i < 101; ++i) numbers.push_back(i * 37 % 101);
    tbb::parallel_sort(numbers, std::greater{});
    EXPECT_TRUE(std::ranges::is_sorted(numbers, std::greater{}));
}

TEST(StandIn, EveryThreadHasOneElement) {
    tbb::enumerable_thread_specific<int> counts([] { return 1000; });
    tbb::enumerable_thread_specific<std::string> others;
    tbb::parallel_for(0, many, [&](int) {
        ++counts.local();
        others.local() += 'x';
    });
    int sum = 0;
    for (const int count : counts) sum += count;
    EXPECT_EQ(sum, 4 * 1000 + many);
    std::vector<std::string> letters;
    for (const std::string& other : others) letters.push_back(other);
    EXPECT_EQ(letters.size(), 4u);
    EXPECT_EQ(std::accumulate(letters.begin(), letters.end(), std::string()), std::string(many, 'x'));
}

TEST(StandIn, ExceptionReachesTheCaller) {
    const auto loop = [] {
        tbb::parallel_for(0, many, [](int i) {
            if (i == many / 2) throw std::range_error("from a body");
        });
    };
    EXPECT_THROW(loop(), std::range_error);
    EXPECT_EQ(threads_of_loop(), 4u);
}

}  // namespace
