#include "program/interrupt.h"

#include <unistd.h>

#include <tbb/task_group.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

namespace zproof {
namespace {

/// A signal handler can reach nothing but statics, and those must be lock-free: the only globals of the
/// program.
std::atomic<bool> noted = false;
std::atomic<pid_t> heir = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

constexpr std::string_view answer =
    "\nzproof: interrupted; finishing the piece in hand (once more: ends at once)\n";

/// Does only what POSIX allows in a signal handler.
extern "C" void note_signal(int number) {
    if (noted.exchange(true)) return;
    if (const pid_t process = heir) {
        ::kill(process, number);
        return;
    }
    [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, answer.data(), answer.size());
}

extern "C" void let_the_write_fail(int) {}

/// Who started zproof may have said that it outlives the terminal (nohup).
bool is_ignored(int signal_number) {
    struct sigaction now {};
    return sigaction(signal_number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void fail_writes_on(int signal_number) {
    struct sigaction heard {};
    heard.sa_handler = let_the_write_fail;
    heard.sa_flags = SA_RESTART;
    sigaction(signal_number, &heard, nullptr);
}

void hand_interrupts_to(pid_t process) { heir = process; }

void note_interrupts(SecondInterrupt second) {
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = SA_RESTART;
    if (second == SecondInterrupt::ends_the_program) action.sa_flags |= int(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    if (!is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);
    fail_writes_on(SIGPIPE);
}

bool interrupted() { return noted; }

bool done_uninterrupted(const std::function<void()>& work) {
    tbb::task_group_context context;
    std::mutex mutex;
    std::condition_variable_any is_over;
    const auto watch = [&](const std::stop_token& stop) {
        std::unique_lock lock(mutex);
        while (!stop.stop_requested()) {
            if (interrupted()) context.cancel_group_execution();
            is_over.wait_for(lock, stop, std::chrono::milliseconds(50), [] { return false; });
        }
    };
    const std::jthread watcher(watch);
    tbb::task_group(context).run_and_wait(work);
    return !interrupted();
}

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
