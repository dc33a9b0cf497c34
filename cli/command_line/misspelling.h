/// "Did you mean ...?" for commands and options.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace zproof {

/// Of what the tree has just failed to parse: "; did you mean 'run'?" where the first word that nobody
/// expected is nearly a command or an option of the command that was typed, else "".
std::string misspelling_in(const CLI::App& root);

}  // namespace zproof
