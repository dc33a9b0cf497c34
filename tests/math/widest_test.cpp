#include "math/widest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace zproof {
namespace {

/// Where a function is called from tells which copy of its caller runs.
[[gnu::noinline]] const char* caller() { return static_cast<const char*>(__builtin_return_address(0)); }

/// Not the caller's own value: a call in the last place would be a jump.
const char* place_of_copy() { return caller() + 1; }

/// What the compiler would contract or reorder, were it allowed to.
void mix(const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < from.size(); ++i)
        to[i] = std::sqrt(from[i] * from[i] + 1 / from[i]) - from[i];
}

/// Calls work() once for each instruction set that the processor has, widest last.
template <class Work>
void for_each_set(const Work& work) {
    const InstructionSet before = widest_allowed();
    for (const InstructionSet set : instruction_sets()) {
        allow_at_most(set);
        work();
    }
    allow_at_most(before);
}

#ifdef __OPTIMIZE__  // without, nothing is inlined into a copy
TEST(Widest, RunsACopyOfItsOwnForEachInstructionSet) {
    std::vector<const char*> places, places_up_to_avx2;
    for_each_set([&] {
        places.push_back(widest<place_of_copy>());
        places_up_to_avx2.push_back(widest<place_of_copy, InstructionSet::avx2>());
    });
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(places[i], places[k]) << name_of(instruction_sets()[i]);
    if (places.size() > 2) {
        EXPECT_EQ(places_up_to_avx2[2], places_up_to_avx2[1]);
    }
}
#endif

TEST(Widest, GivesTheSameBits) {
    std::vector<double> from(1001), expected(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) from[i] = 0.1 + double(i * 7919 % 1001) / 3;
    mix(from, expected);
    for_each_set([&] {
        std::vector<double> found(from.size());
        widest<mix>(from, found);
        EXPECT_EQ(found, expected) << name_of(widest_allowed());
    });
}

}  // namespace
}  // namespace zproof
