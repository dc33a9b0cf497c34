/// Ctrl-C as a question that long work asks between two pieces of it.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "cli/exit_code.h"

namespace zproof {

/// From now on the first SIGINT or SIGTERM is only noted, and stderr says that the piece in hand will be
/// finished; a second one ends the program at once, and with it every program that it has started.
void note_interrupts();

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
