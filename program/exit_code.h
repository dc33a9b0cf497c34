/// What a caller learns from the exit status alone (docs/cli.md). Never a count.
#pragma once

#include <span>
#include <string_view>

namespace zproof {

enum class ExitCode : int {
    proven = 0,  ///< everything that was judged is right
    defect = 1,  ///< at least one pixel fails the gate, a suite scene no longer shows what it is there for,
                 ///< or a renderer is worse than it declares
    usage = 2,   ///< the command line cannot be understood
    cannot_judge = 3,  ///< an input is unreadable, a tool refused, or a result could not be written
    nothing = 4,       ///< nothing was judged at all
    internal = 70,     ///< our own fault (EX_SOFTWARE of sysexits.h)
    interrupted = 130  ///< ended by Ctrl-C or SIGTERM; what was judged until then is written
};

/// A row of the table in docs/cli.md, word for word.
struct ExitStatus {
    ExitCode code;
    std::string_view meaning;
};

/// What --help says of them.
inline constexpr const char* exit_statuses_in_help = R"(
Exit status: 0 proven, 1 a defect, 2 usage, 3 unreadable input, 4 nothing judged, 70 internal error,
130 interrupted.)";

/// All exit statuses, by number.
std::span<const ExitStatus> exit_statuses();

}  // namespace zproof
