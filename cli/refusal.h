/// What a command cannot do where the world refuses it: a file, a tool, a result that cannot be written.
#pragma once

#include <string_view>

#include "cli/arguments.h"

namespace zproof {

/// "cannot judge" of the commands that judge, "cannot report", "cannot list the waivers", ...
std::string_view refusal_of(const Command& command);

}  // namespace zproof
