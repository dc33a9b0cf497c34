/// Ctrl-C as a question that long work asks between two pieces of it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string_view>

#include "program/exit_code.h"

namespace zproof {

enum class SecondInterrupt {
    ends_the_program,  ///< at once, and with it every program that it has started
    is_ignored,
};

/// From now on the first SIGINT or SIGTERM is only noted, and stderr says that the piece in hand will be
/// finished.
void note_interrupts(SecondInterrupt second = SecondInterrupt::ends_the_program);

/// What is noted goes to this process as well, and it is the one to answer; 0: to nobody.
void hand_interrupts_to(pid_t process);

/// A write into a pipe that nobody reads (SIGPIPE), or beyond the longest file that is allowed (SIGXFSZ),
/// fails then, and is heard to fail. A handler is not handed on to programs that are started, as SIG_IGN
/// would be.
void fail_writes_on(int signal_number);

/// Has one been noted?
bool interrupted();

/// Does the work, and cancels its parallel loops when an interrupt is noted: what it made then is incomplete.
/// False where that happened.
bool done_uninterrupted(const std::function<void()>& work);

/// How much of some work was done.
struct Share {
    std::size_t done, all;
    std::size_t scenes_left = 0;  ///< not begun: how much they are of the work is not known
};

/// Says on stderr what is finished and what is not: "zproof: interrupted: 2 of 5 views judged and written, 3
/// not; 4 scenes not begun". Returns ExitCode::interrupted.
ExitCode say_interrupted(Share share, std::string_view unit, std::string_view how);

}  // namespace zproof
