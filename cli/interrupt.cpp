#include "cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace zproof {
namespace {

/// A signal handler can reach nothing but a static, and that must be lock-free: the one global of the
/// program.
std::atomic<bool> noted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note(int) { noted = true; }

}  // namespace

void note_interrupts() {
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return noted; }

}  // namespace zproof
