#include "rasterizer/bin_entries.h"

#include <gtest/gtest.h>

#include <numeric>

namespace zproof::rasterizer {
namespace {

std::vector<std::uint32_t> written(const BinEntries& list) {
    return {list.data(), list.data() + list.size()};
}

std::vector<std::uint32_t> first_numbers(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

/// One by one and several at a time, within what is lent, to its end and beyond.
TEST(BinEntries, HoldsAllThatWasAdded) {
    for (const std::size_t room : {0u, 1u, 5u, 16u, 17u, 100u}) {
        std::vector<std::uint32_t> lent(room);
        BinEntries list;
        list.begin_in(lent);
        for (std::uint32_t i = 0; i < 40;) {
            if (i % 3 == 0) {
                std::uint32_t* const three = list.add(3);
                for (int k = 0; k < 3; ++k) three[k] = i++;
            } else {
                list.push_back(i++);
            }
            EXPECT_EQ(written(list), first_numbers(i)) << room;
        }
    }
}

TEST(BinEntries, LeavesAloneWhatLiesBeyondTheLentMemory) {
    std::vector<std::uint32_t> memory(10, 77);
    BinEntries list;
    list.begin_in(std::span(memory).first(4));
    for (std::uint32_t i = 0; i < 20; ++i) list.push_back(i);
    EXPECT_EQ(std::vector(memory.begin() + 4, memory.end()), std::vector<std::uint32_t>(6, 77));
    EXPECT_EQ(written(list), first_numbers(20));
}

/// Into lent memory again, and from there into its own, which is not empty any more.
TEST(BinEntries, BeginsAnew) {
    BinEntries list;
    for (const std::size_t count : {20u, 3u, 9u, 50u, 0u}) {
        std::vector<std::uint32_t> lent(4, 99);
        list.begin_in(lent);
        EXPECT_EQ(list.size(), 0u);
        for (std::uint32_t i = 0; i < count; ++i) list.push_back(i);
        EXPECT_EQ(written(list), first_numbers(count));
    }
}

}  // namespace
}  // namespace zproof::rasterizer
