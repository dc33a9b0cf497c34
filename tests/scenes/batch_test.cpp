#include "scenes/batch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace zproof {
namespace {

TEST(Batch, CallsWorkOnceForEveryElementOfEveryLength) {
    const std::vector<std::size_t> lengths{0,
                                           1,
                                           Batch::range_elements - 1,
                                           Batch::range_elements,
                                           Batch::range_elements + 1,
                                           5 * Batch::range_elements + 7};
    std::vector<std::vector<std::atomic<int>>> calls;
    for (const std::size_t length : lengths) calls.emplace_back(length);
    Batch batch;
    for (std::vector<std::atomic<int>>& each : calls)
        batch.add(each.size(), [&each](std::size_t from, std::size_t to) {
            EXPECT_LT(from, to);
            EXPECT_LE(to - from, Batch::range_elements);
            for (std::size_t i = from; i < to; ++i) ++each.at(i);
        });
    batch.run();
    for (const std::vector<std::atomic<int>>& each : calls)
        for (const std::atomic<int>& count : each) ASSERT_EQ(count, 1) << "of " << each.size();
}

TEST(Batch, ForgetsWhatItHasDone) {
    std::atomic<int> calls = 0;
    Batch batch;
    batch.add(3, [&](std::size_t, std::size_t) { ++calls; });
    batch.run();
    batch.run();
    EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace zproof
