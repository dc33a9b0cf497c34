#include "cli/command_line/outline.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <sstream>

namespace zproof {
namespace {

/// The words of "TEXT:{always,auto,never}"; none where it is another kind.
std::vector<std::string> choices_in(const std::string& kind) {
    const std::size_t open = kind.find(":{");
    if (open == std::string::npos || kind.back() != '}') return {};
    std::istringstream in{kind.substr(open + 2, kind.size() - open - 3)};
    std::vector<std::string> words;
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

Takes takes_of(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0) return Takes::nothing;
    return option.get_expected_max() > 1 && option.get_allow_extra_args() ? Takes::many : Takes::one;
}

std::vector<std::string> names_of(const CLI::Option& option) {
    if (!option.nonpositional()) return {option.get_name(true)};
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

OutlineOption outline_of(const CLI::Option& option) {
    const std::string kind = option.get_type_name();
    return {.names = names_of(option),
            .takes = takes_of(option),
            .choices = choices_in(kind),
            .kind = takes_of(option) == Takes::nothing ? "" : kind,
            .description = option.get_description(),
            .default_value = option.get_default_str()};
}

OutlineCommand outline_of(const CLI::App& app, const std::string& path) {
    OutlineCommand command{.path = path,
                           .description = app.get_description(),
                           .footer = app.get_footer(),
                           .options = {},
                           .positionals = {},
                           .commands = {}};
    for (const CLI::Option* option : app.get_options())
        (option->nonpositional() ? command.options : command.positionals).push_back(outline_of(*option));
    for (const CLI::App* below : app.get_subcommands(std::function<bool(const CLI::App*)>{}))
        command.commands.push_back(outline_of(*below, path + (path.empty() ? "" : " ") + below->get_name()));
    return command;
}

}  // namespace

std::string OutlineCommand::name() const { return path.substr(path.rfind(' ') + 1); }

OutlineCommand outline_of(const CLI::App& root) { return outline_of(root, ""); }

std::vector<OutlineCommand> leaves_of(const OutlineCommand& root) {
    if (root.commands.empty()) return {root};
    std::vector<OutlineCommand> leaves;
    for (const OutlineCommand& command : root.commands)
        std::ranges::copy(leaves_of(command), std::back_inserter(leaves));
    return leaves;
}

}  // namespace zproof
