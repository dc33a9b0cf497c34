#include "oracle/strays.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>
extern "C" {
#include <sys/pidfd.h>  // glibc 2.36 forgets to say that it is C
}

#include <algorithm>
#include <atomic>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "oracle/file_descriptor.h"

namespace zproof::oracle {
namespace {

namespace fs = std::filesystem;

bool has_mark(const fs::path& process, const std::string& mark) {
    std::ifstream in(process / "environ", std::ios::binary);
    const std::string environment{std::istreambuf_iterator<char>(in), {}};
    const std::string entry = mark + '\0';
    const std::size_t at = environment.find(entry);
    return at == 0 || (at != std::string::npos && environment[at - 1] == '\0');
}

/// Kills it where it is marked, and waits until it is gone. The number may be another's meanwhile: what is
/// held open first is not. False where there is nothing to kill.
bool ends(const fs::path& process, const std::string& mark) {
    constexpr int longest_wait_ms = 1000;
    const FileDescriptor held(pidfd_open(std::stoi(process.filename().string()), 0));
    if (!held.is_open() || !has_mark(process, mark)) return false;
    if (pidfd_send_signal(held.number(), SIGKILL, nullptr, 0) != 0) return false;
    pollfd gone{held.number(), POLLIN, 0};
    poll(&gone, 1, longest_wait_ms);
    return true;
}

bool is_number(const std::string& name) {
    return name.size() < 10 &&
           std::ranges::all_of(name, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Returns how many it found.
int end_those_of_now(const std::string& mark) {
    int count = 0;
    std::error_code failure;  // a range's loop would throw where the folder cannot be read on
    for (auto i = fs::directory_iterator("/proc", failure); !failure && i != end(i); i.increment(failure))
        if (is_number(i->path().filename().string())) count += ends(i->path(), mark) ? 1 : 0;
    return count;
}

}  // namespace

std::string next_command_mark() {
    static std::atomic<unsigned> count = 0;
    return "ZPROOF_COMMAND=" + std::to_string(getpid()) + "-" + std::to_string(++count);
}

void end_strays(const std::string& mark) {
    constexpr int most_rounds = 100;
    for (int round = 0; round < most_rounds && end_those_of_now(mark) > 0; ++round) {
    }
}

}  // namespace zproof::oracle
