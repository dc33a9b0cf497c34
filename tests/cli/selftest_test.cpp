// zproof selftest, on the real program.
#include <gtest/gtest.h>

#include <algorithm>

#include "selftest/fault.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

TEST(Selftest, TellsEveryFaultAndEndsWithZero) {
    const Folder folder;
    const Ran ran = run(folder, {"selftest"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(ran.err, "");
    const std::size_t faults = selftest::catalogue().size();
    EXPECT_GE(faults, 60u);
    EXPECT_EQ(std::size_t(std::ranges::count(ran.out, '\n')), faults + 1) << ran.out;
    EXPECT_NE(ran.out.find("\nthe gate works: "), std::string::npos) << ran.out;
    EXPECT_EQ(folder.names(), Words{});
}

TEST(Selftest, SaysTheSameForAnyNumberOfThreads) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"selftest", "--threads", "1"}).out,
              run(folder, {"selftest", "--threads", "3"}).out);
}

}  // namespace
}  // namespace zproof::test
