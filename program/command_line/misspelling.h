/// "Did you mean ...?" for commands and options.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace zproof {

/// "; did you mean 'run'?" where the first unexpected word of the command line that `root` just failed to
/// parse is nearly a command or an option of the command that was typed, else "".
std::string misspelling_in(const CLI::App& root);

}  // namespace zproof
