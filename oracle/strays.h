/// Processes that a command starts and that leave its process group.
#pragma once

#include <string>

namespace zproof::oracle {

/// An entry of the environment, another one at each call, by which a command and all that it starts are
/// known: "ZPROOF_COMMAND=812-3".
std::string next_command_mark();

/// Kills every process that has the entry in its environment, and those that they start meanwhile. Whoever
/// empties the environment or changes the user is not found.
void end_strays(const std::string& mark);

}  // namespace zproof::oracle
