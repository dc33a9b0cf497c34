/// The one place where errors meet. A failing pixel is a result and is not among them.
#pragma once

#include <functional>
#include <string_view>

#include "program/exit_code.h"

namespace zproof {

/// Does the work. What it throws becomes a line on stderr and an exit code; `refusal`, as it is then, says
/// what could not be done.
ExitCode report_failures(const std::string_view& refusal, const std::function<ExitCode()>& work);

}  // namespace zproof
