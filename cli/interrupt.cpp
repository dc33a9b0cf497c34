#include "cli/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <string>

namespace zproof {
namespace {

/// A signal handler can reach nothing but a static, and that must be lock-free: the one global of the
/// program.
std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr std::string_view answer =
    "\nzproof: interrupted; finishing the piece in hand (once more: ends at once)\n";

/// Does only what POSIX allows in a signal handler.
extern "C" void note(int) {
    if (noted.exchange(true)) return;
    [[maybe_unused]] const ssize_t told = write(STDERR_FILENO, answer.data(), answer.size());
}

}  // namespace

void note_interrupts() {
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return noted; }

ExitCode say_interrupted(Share share, std::string_view unit, std::string_view how) {
    std::cerr << "zproof: interrupted: ";
    if (share.all == 0)
        std::cerr << "no " << unit << " " << how;
    else
        std::cerr << share.done << " of " << share.all << " " << unit << (share.all == 1 ? " " : "s ") << how
                  << ", " << share.all - share.done << " not";
    if (share.scenes_left > 0)
        std::cerr << "; " << share.scenes_left << (share.scenes_left == 1 ? " scene" : " scenes")
                  << " not begun";
    std::cerr << "\n";
    return ExitCode::interrupted;
}

}  // namespace zproof
