/// The text of --help: what a command does, its examples, its usage and options.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace zproof {

struct Example {
    std::string_view command;  ///< "run", "filters check"; empty: of zproof as a whole
    std::string_view line;     ///< as typed in a shell
    std::string_view meaning;  ///< a few words
};

/// A program's, in the order of its commands.
using Examples = std::span<const Example>;

/// Those of one command, a line or two each, ending in a newline; empty where it has none.
std::string in_words(Examples examples, std::string_view command);

/// Makes `root` and everything added below it later show examples in their help.
void explain_by_example(CLI::App& root, Examples examples);

}  // namespace zproof
