// Work that ends in every bad way: the process that asked for it goes on, and knows why.
#include "oracle/isolated.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <thread>

#include "frame/frame_error.h"
#include "tests/frame/scratch_folder.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr IsolationLimits generous{std::size_t{1} << 30, std::chrono::minutes(5)};

std::string complaint_of(const std::function<Bytes()>& work, const IsolationLimits& limits = generous) {
    return complaint<FrameError>([&] { isolated("x.exr", limits, work); });
}

TEST(Isolated, GivesWhatTheWorkReturns) {
    const Bytes large(std::size_t{3} << 20, std::byte{7});
    EXPECT_EQ(isolated("x.exr", generous, [&] { return large; }), large);
    EXPECT_TRUE(isolated("x.exr", generous, [] { return Bytes{}; }).empty());
}

TEST(Isolated, HandsOnTheWordsOfARefusal) {
    EXPECT_EQ(complaint_of([]() -> Bytes { throw FrameError("x.exr: no channel"); }), "x.exr: no channel");
    EXPECT_EQ(complaint_of([]() -> Bytes { throw std::logic_error("odd"); }), "x.exr: cannot be read: odd");
}

TEST(Isolated, NamesTheSignalThatEndedIt) {
    for (const int number : {SIGFPE, SIGSEGV, SIGABRT, SIGKILL}) {
        const std::string said = complaint_of([=]() -> Bytes {
            signal(number, SIG_DFL);
            kill(getpid(), number);
            return {};
        });
        EXPECT_THAT(said, StartsWith("x.exr: cannot be read: its reader crashed (signal "));
        EXPECT_THAT(said, HasSubstr(strsignal(number)));
    }
}

/// As if it had been killed while it answered: the start of an answer stands in every pipe that is open.
TEST(Isolated, IsNotBelievedWhereItsAnswerIsCut) {
    for (const std::size_t count : {1, 16, 20}) {
        const std::string said = complaint_of([&]() -> Bytes {
            Bytes start(count);
            if (count >= 16) start[8] = std::byte{9};  // of nine bytes
            for (int file = 3; file < 256; ++file) {
                struct stat status {};
                if (fstat(file, &status) != 0 || !S_ISFIFO(status.st_mode)) continue;
                if (::write(file, start.data(), start.size()) < 0) continue;
            }
            signal(SIGSEGV, SIG_DFL);
            raise(SIGSEGV);
            return {};
        });
        EXPECT_THAT(said, HasSubstr("its reader crashed")) << count;
    }
}

/// A whole answer is not waited for any longer, although something holds the pipe open: here a descendant.
TEST(Isolated, IsDoneWhenItsAnswerIsWhole) {
    const IsolationLimits limits{generous.memory_bytes, std::chrono::seconds(20)};
    const auto leaves_a_descendant = [] {
        if (fork() == 0) {
            alarm(25);
            for (;;) pause();
        }
        return Bytes(5);
    };
    EXPECT_EQ(isolated("x.exr", limits, leaves_a_descendant).size(), 5u);
}

TEST(Isolated, IsEndedByNoInterruptOfItsParent) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP})
        EXPECT_FALSE(isolated("x.exr", generous, [=] {
                         raise(number);
                         return Bytes(1);
                     }).empty());
}

TEST(Isolated, EndsAtItsTimeLimit) {
    EXPECT_EQ(complaint_of(
                  []() -> Bytes {
                      for (;;) pause();
                  },
                  {generous.memory_bytes, std::chrono::milliseconds(20)}),
              "x.exr: cannot be read within the time limit of 1 s");
}

TEST(Isolated, EndsAtItsMemoryLimit) {
    const auto greedy = [] { return Bytes(std::size_t{200} << 20); };
    EXPECT_EQ(isolated("x.exr", generous, greedy).size(), std::size_t{200} << 20);
    EXPECT_EQ(complaint_of(greedy, {std::size_t{100} << 20, std::chrono::minutes(5)}),
              "x.exr: cannot be read: more memory is needed than is allowed, 100 MiB");
}

TEST(Isolated, TouchesNothingOfThisProcess) {
    int value = 1;
    isolated("x.exr", generous, [&] {
        value = 2;
        return Bytes{};
    });
    EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace zproof::oracle
