#include "program/exit_code.h"

#include <array>

namespace zproof {
namespace {

constexpr std::array rows{
    ExitStatus{ExitCode::proven, "proven: everything that was judged is right"},
    ExitStatus{
        ExitCode::defect,
        "a defect: a pixel fails the gate, a waiver has expired, a suite scene no longer shows what it is "
        "there for, or a renderer is worse than it declares"},
    ExitStatus{ExitCode::usage,
               "usage: the command line, a settings file or a waiver file cannot be understood"},
    ExitStatus{ExitCode::cannot_judge,
               "an input is unreadable, memory is too small, a tool is missing or refused, a result cannot "
               "be written, or pixels are "
               "undecidable at the declared precision"},
    ExitStatus{ExitCode::nothing, "nothing was judged at all"},
    ExitStatus{ExitCode::internal, "internal error: a fault of zproof's own"},
    ExitStatus{ExitCode::interrupted, "interrupted"},
};

}  // namespace

std::span<const ExitStatus> exit_statuses() { return rows; }

}  // namespace zproof
