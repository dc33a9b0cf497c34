// Programs that behave and programs that do not: what comes back, and what is left behind.
#include "oracle/subprocess.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "oracle/oracle_error.h"
#include "oracle/scratch_folder.h"

namespace zproof::oracle {
namespace {

using std::chrono::milliseconds;

Outcome run_line(const std::string& line, milliseconds limit = std::chrono::minutes(1)) {
    return run({.arguments = shell_line(line), .time_limit = limit});
}

std::string complaint_about(const Command& command) {
    try {
        run(command);
    } catch (const OracleError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(Subprocess, BothOutputsAndTheStatusComeBack) {
    const Outcome outcome = run_line("echo said; echo complained >&2; exit 7");
    EXPECT_EQ(outcome.ending, Ending::exited);
    EXPECT_EQ(outcome.code, 7);
    EXPECT_EQ(outcome.output, "said\n");
    EXPECT_EQ(outcome.error_output, "complained\n");
    EXPECT_FALSE(outcome.succeeded());
    EXPECT_TRUE(run_line("true").succeeded());
}

TEST(Subprocess, ArgumentsReachTheProgramAsTheyAre) {
    const Outcome outcome = run({.arguments = {"printf", "%s|", "two words", "$HOME", "'", ""}});
    EXPECT_EQ(outcome.output, "two words|$HOME|'||");
}

TEST(Subprocess, StartedCommandsRunSideBySide) {
    const ScratchFolder scratch;  // each waits for the other's file
    const auto meet = [&](const std::string& mine, const std::string& other) {
        return start(
            {.arguments = shell_line("touch " + mine + "; until [ -e " + other + " ]; do :; done; echo met"),
             .folder = scratch.path(),
             .time_limit = std::chrono::minutes(1)});
    };
    const auto first = meet("a", "b"), second = meet("b", "a");
    EXPECT_EQ(first().output, "met\n");
    EXPECT_EQ(second().output, "met\n");
}

TEST(Subprocess, ACommandThatNobodyWaitsForIsKilled) {
    const ScratchFolder scratch;
    const std::string pipe = scratch.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    auto forgotten = start({.arguments = shell_line("exec 3>" + pipe + "; sleep 1000")});
    const int reader = open(pipe.c_str(), O_RDONLY | O_CLOEXEC);  // returns when the command has opened it
    ASSERT_GE(reader, 0);
    forgotten = nullptr;
    char nothing = 0;
    EXPECT_EQ(read(reader, &nothing, 1), 0);  // its end: nobody holds the other one
    close(reader);
}

TEST(Subprocess, StandardInputIsEmpty) { EXPECT_EQ(run_line("cat; echo done").output, "done\n"); }

TEST(Subprocess, ItRunsInItsFolder) {
    const ScratchFolder scratch;
    EXPECT_EQ(run({.arguments = {"pwd"}, .folder = scratch.path()}).output, scratch.path().string() + "\n");
}

TEST(Subprocess, OnlyTheEndOfALongOutputIsKept) {
    const std::string talk = "i=0; while [ $i -lt 40000 ]; do echo line $i; i=$((i+1)); done";
    const Outcome outcome = run({.arguments = shell_line(talk), .kept_bytes = 1000});
    EXPECT_EQ(outcome.output.size(), 1000u);
    EXPECT_THAT(outcome.output, testing::EndsWith("line 39999\n"));
}

TEST(Subprocess, ASignalHasItsNumber) {
    const Outcome outcome = run_line("kill -SEGV $$");
    EXPECT_EQ(outcome.ending, Ending::killed);
    EXPECT_EQ(outcome.code, SIGSEGV);
}

TEST(Subprocess, AProgramThatHangsIsStoppedAndItsOutputKept) {
    const Outcome outcome = run_line("echo before; exec sleep 1000", milliseconds(200));
    EXPECT_EQ(outcome.ending, Ending::timed_out);
    EXPECT_EQ(outcome.output, "before\n");
}

TEST(Subprocess, AProgramThatIgnoresTermIsStoppedToo) {
    EXPECT_EQ(run_line("trap '' TERM INT HUP; while :; do :; done", milliseconds(200)).ending,
              Ending::timed_out);
}

TEST(Subprocess, AProgramThatNeverStopsWritingIsStopped) {
    EXPECT_EQ(run({.arguments = {"yes"}, .time_limit = milliseconds(200)}).ending, Ending::timed_out);
}

/// Hears who writes into a FIFO, until the last one who holds it open has ended.
class HeldFifo {
  public:
    HeldFifo() {
        mkfifo(path().c_str(), 0600);
        reader_ = open(path().c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        fcntl(reader_, F_SETFL, 0);
    }
    ~HeldFifo() { close(reader_); }
    std::string path() const { return scratch_.path() / "fifo"; }

    /// The first character, once somebody has opened the FIFO and written it.
    char first_character() const {
        char c = 0;
        while (read(reader_, &c, 1) != 1) std::this_thread::yield();
        return c;
    }

    std::string all_that_was_written() const {
        std::string text;
        for (char c; read(reader_, &c, 1) == 1;) text += c;
        return text;
    }

  private:
    ScratchFolder scratch_;
    int reader_;
};

/// Killing the shell alone would leave its child, which then holds our pipes and writes its word.
TEST(Subprocess, ATimeLimitEndsChildrenOfTheProgramAsWell) {
    const HeldFifo fifo;
    const std::string line =
        "exec 3>" + fifo.path() + "; echo started >&3; (sleep 20; echo survived >&3) & wait";
    EXPECT_EQ(run_line(line, milliseconds(500)).ending, Ending::timed_out);
    EXPECT_EQ(fifo.all_that_was_written(), "started\n");
}

TEST(Subprocess, AChildLeftBehindIsEndedAndNotWaitedFor) {
    const HeldFifo fifo;
    const std::string line = "exec 3>" + fifo.path() + "; echo started >&3; (sleep 20; echo survived >&3) &";
    EXPECT_TRUE(run_line(line).succeeded());
    EXPECT_EQ(fifo.all_that_was_written(), "started\n");
}

TEST(Subprocess, AChildInASessionOfItsOwnIsEndedToo) {
    const HeldFifo fifo;
    const ScratchFolder folder;
    const std::string ready = folder.path() / "ready";
    const std::string daemon = "echo yes >" + ready + "; sleep 20; echo survived >&3";
    EXPECT_TRUE(run_line("exec 3>" + fifo.path() + "; echo started >&3; setsid sh -c '" + daemon +
                         "' >/dev/null 2>&1 & while [ ! -s " + ready + " ]; do :; done")
                    .succeeded());
    EXPECT_EQ(fifo.all_that_was_written(), "started\n");
}

/// A process that runs the line and is killed, with no chance to tidy up, as soon as the line has begun.
void kill_amid(const std::string& line, const HeldFifo& fifo) {
    const pid_t runner = fork();
    if (runner == 0) {
        run_line(line);
        _exit(0);
    }
    EXPECT_EQ(fifo.first_character(), 's');
    kill(runner, SIGKILL);
    waitpid(runner, nullptr, 0);
}

TEST(Subprocess, NothingOutlivesTheProcessThatRanIt) {
    const HeldFifo fifo;
    kill_amid("exec 3>" + fifo.path() + "; echo started >&3; (sleep 20; echo survived >&3) & wait", fifo);
    EXPECT_EQ(fifo.all_that_was_written(), "tarted\n");
}

TEST(Subprocess, AMissingProgramIsNamed) {
    EXPECT_THAT(complaint_about({.arguments = {"no-such-program"}}),
                testing::StartsWith("no-such-program: cannot be started in .: No such file or directory"));
    EXPECT_THAT(complaint_about({.arguments = {"true"}, .folder = "/no/such/folder"}),
                testing::HasSubstr("/no/such/folder"));
}

TEST(Subprocess, EndingsHaveWords) {
    const milliseconds limit(2500);
    EXPECT_EQ(in_words({.ending = Ending::exited, .code = 3}, limit), "exit status 3");
    EXPECT_EQ(in_words({.ending = Ending::killed, .code = SIGSEGV}, limit),
              "killed by signal 11 (Segmentation fault)");
    EXPECT_EQ(in_words({.ending = Ending::timed_out}, limit), "stopped at its time limit of 2.5 s");
}

TEST(ScratchFolder, IsNewAndEmptyAndGoneAfterwards) {
    std::filesystem::path path;
    {
        const ScratchFolder one, other;
        path = one.path();
        EXPECT_NE(path, other.path());
        EXPECT_TRUE(std::filesystem::is_empty(path));
        std::filesystem::create_directories(path / "a/b");
        std::ofstream(path / "a/b/file") << "text";
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFolder, GoesWithAnExceptionToo) {
    std::filesystem::path path;
    try {
        const ScratchFolder scratch;
        path = scratch.path();
        throw OracleError("trouble");
    } catch (const OracleError&) {
        EXPECT_FALSE(std::filesystem::exists(path));
    }
}

}  // namespace
}  // namespace zproof::oracle
