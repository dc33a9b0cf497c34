#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

/// A pipe that is full: whoever writes to it waits until it is read.
struct FullPipe {
    int read_end = -1, write_end = -1;

    FullPipe() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error{"no pipe"};
        read_end = ends[0];
        write_end = ends[1];
        const int flags = fcntl(write_end, F_GETFL);
        fcntl(write_end, F_SETFL, flags | O_NONBLOCK);
        for (const char fill = '.'; write(write_end, &fill, 1) == 1;) continue;
        fcntl(write_end, F_SETFL, flags);
    }
    ~FullPipe() { close(read_end); }
    FullPipe(const FullPipe&) = delete;
    FullPipe& operator=(const FullPipe&) = delete;

    void drain() {
        close(write_end);
        std::array<char, 4096> buffer;
        while (read(read_end, buffer.data(), buffer.size()) > 0) continue;
    }
};

/// Does the process catch SIGINT by now? The kernel says so in /proc/PID/status.
bool catches_interrupts(pid_t pid) {
    std::ifstream status{"/proc/" + std::to_string(pid) + "/status"};
    for (std::string word; status >> word;)
        if (word == "SigCgt:" && status >> word)
            return ((std::stoull(word, nullptr, 16) >> (SIGINT - 1)) & 1) != 0;
    return false;
}

/// Runs both scenes and interrupts while the program waits to tell of the first: the second cannot have
/// begun.
int interrupted_run(const Folder& folder, int signal_number) {
    FullPipe progress;
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const pid_t pid =
        start(folder, {"run", "a.gltf", "b.gltf", "--progress", "lines", "--width", "64", "--height", "48"},
              {nowhere, progress.write_end});
    while (!catches_interrupts(pid)) std::this_thread::yield();
    kill(pid, signal_number);
    progress.drain();
    close(nowhere);
    return exit_code_of(pid);
}

TEST(Interrupt, WritesWhatWasJudgedAndMarksTheRest) {
    for (const int signal_number : {SIGINT, SIGTERM}) {
        const Folder folder;
        folder.write("a.gltf", one_triangle());
        folder.write("b.gltf", two_triangles());
        EXPECT_EQ(interrupted_run(folder, signal_number), 130);
        const auto views = nlohmann::json::parse(folder.read("zproof-out/results.json")).at("views");
        ASSERT_EQ(views.size(), 2u);
        EXPECT_EQ(views[1].at("scene"), "b");
        EXPECT_EQ(views[1].at("outcome"), "not_judged");
        EXPECT_EQ(views[1].at("message"), "interrupted before it was judged");
        EXPECT_EQ(folder.names(), (Words{"a.gltf", "b.gltf", "zproof-out"}));
    }
}

}  // namespace
}  // namespace zproof::test
