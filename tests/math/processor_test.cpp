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
    EXPECT_EQ(has_avx2(), known.contains("avx2"));
    EXPECT_EQ(has_avx512(), known.contains("avx512f") && known.contains("avx512dq") &&
                                known.contains("avx512vl") && known.contains("avx512bw"));
}

TEST(Processor, RunsKernelsNarrowestFirst) {
    std::vector<std::string> expected{"scalar"};
    if (has_avx2()) expected.push_back("avx2");
    if (has_avx512()) expected.push_back("avx512");
    EXPECT_EQ(runnable<std::string>("scalar", "avx2", "avx512"), expected);
}

}  // namespace
}  // namespace zproof
