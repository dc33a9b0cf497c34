#include "math/processor.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace zproof {
namespace {

/// What the kernel has found the processor to have; nothing where it does not list flags.
std::set<std::string> flags() {
    std::ifstream file("/proc/cpuinfo");
    std::set<std::string> flags;
    for (std::string line; std::getline(file, line) && flags.empty();) {
        if (!line.starts_with("flags")) continue;
        std::istringstream words(line.substr(line.find(':') + 1));
        for (std::string word; words >> word;) flags.insert(word);
    }
    return flags;
}

TEST(Processor, HasWhatTheKernelSays) {
    const std::set<std::string> known = flags();
    std::vector<InstructionSet> expected{InstructionSet::scalar};
    if (known.contains("avx2")) expected.push_back(InstructionSet::avx2);
    if (known.contains("avx512f") && known.contains("avx512dq") && known.contains("avx512vl") &&
        known.contains("avx512bw"))
        expected.push_back(InstructionSet::avx512);
    EXPECT_EQ(instruction_sets(), expected);
}

TEST(Processor, KnowsItsInstructionSetsByName) {
    for (const InstructionSet set : instruction_sets()) EXPECT_EQ(instruction_set_from(name_of(set)), set);
    EXPECT_THROW(instruction_set_from("sse2"), InstructionSetError);
    EXPECT_THROW(instruction_set_from(""), InstructionSetError);
    if (instruction_sets().back() != InstructionSet::avx512) {
        EXPECT_THROW(instruction_set_from("avx512"), InstructionSetError);
    }
}

TEST(Processor, AllowsNoMoreThanItHas) {
    const InstructionSet before = widest_allowed();
    for (const InstructionSet set : instruction_sets()) {
        allow_at_most(set);
        EXPECT_EQ(widest_allowed(), set);
    }
    allow_at_most(InstructionSet::avx512);
    EXPECT_EQ(widest_allowed(), instruction_sets().back());
    allow_at_most(before);
}

}  // namespace
}  // namespace zproof
