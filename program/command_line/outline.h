/// The command line as plain values, for what is written from it: completions and the manual page.
#pragma once

#include <string>
#include <vector>

#include "program/command_line/candidates.h"
#include "program/command_line/help.h"

namespace CLI {
class App;
}

namespace zproof {

enum class Takes {
    nothing,  ///< a flag
    one,      ///< one value
    many,     ///< any number of values
};

struct OutlineOption {
    std::vector<std::string> names;    ///< "-o", "--out"; a positional's one name, "SCENE"
    Takes takes = Takes::nothing;      ///< of positionals: one or many
    std::vector<std::string> choices;  ///< the only words that it takes; empty: others
    std::string kind;                  ///< "TEXT", "INT in [1 - 1024]"; empty for a flag
    std::string description;
    std::string default_value;  ///< empty: none
    Candidates candidates;      ///< for its value
};

struct OutlineCommand {
    std::string path;  ///< "run", "filters check"; empty: zproof itself
    std::string description;
    std::string examples;  ///< a line or two each; empty where it has none
    std::string footer;
    std::vector<OutlineOption> options;      ///< in the order of the help; --help first
    std::vector<OutlineOption> positionals;  ///< in the order of the command line
    std::vector<OutlineCommand> commands;    ///< below it

    std::string name() const;  ///< the last word of the path
};

/// "filters check"; empty for zproof itself.
std::string path_of(const CLI::App& app);

/// Everything that the tree can parse, but what is hidden. A value's candidates: its choices where it has a
/// list of them; else those of its kind; files of a TEXT or FILE, folders of a FOLDER, nothing for all else.
OutlineCommand outline_of(const CLI::App& root, ValueKinds kinds, Examples examples);

/// The commands that can be given by themselves, that is those with no command below them, in order.
std::vector<OutlineCommand> leaves_of(const OutlineCommand& root);

std::string json_of(const OutlineCommand& outline);

/// Throws std::runtime_error where the text is none.
OutlineCommand outline_from(const std::string& json);

}  // namespace zproof
