/// Worked examples of every command: the help and the manual page begin with them, and a test runs each.
#pragma once

#include <span>
#include <string>
#include <string_view>

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

}  // namespace zproof
