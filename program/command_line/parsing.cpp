#include "program/command_line/parsing.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>
#include <vector>

#include "frame/did_you_mean.h"
#include "frame/joined.h"
#include "program/settings/apply.h"
#include "program/usage_error.h"

namespace zproof {

namespace {

/// "zproof filters run".
std::string typed_name_of(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name() : typed_name_of(*parent) + " " + command.get_name();
}

std::vector<std::string> known_to(const CLI::App& app) {
    std::vector<std::string> words;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    for (const CLI::App* command : app.get_subcommands(std::function<bool(const CLI::App*)>{}))
        words.push_back(command->get_name());
    return words;
}

/// "; --width is an option of 'zproof run'": of a command beside the one that was typed; else "".
std::string home_of(const std::string& option, const CLI::App& root) {
    for (const CLI::App* command : root.get_subcommands(std::function<bool(const CLI::App*)>{}))
        if (option.starts_with("-") && command->get_option_no_throw(option) != nullptr)
            return "; " + option + " is an option of '" + typed_name_of(*command) + "'";
    return "";
}

/// What is said of the words that nobody expected, in the order in which they were typed.
std::string in_words(const std::vector<std::string>& unknown, CLI::App& root) {
    const std::string first = unknown.front().substr(0, unknown.front().find('='));
    const std::string home = home_of(first, root);
    return std::string(unknown.size() == 1 ? "The following argument was" : "The following arguments were") +
           " not expected: " + joined(unknown, " ") +
           (home.empty() ? did_you_mean(first, known_to(leaf_of(root))) : home);
}

}  // namespace

CLI::App& leaf_of(CLI::App& app) {
    for (CLI::App* command : app.get_subcommands())
        if (command->parsed()) return leaf_of(*command);
    return app;
}

std::optional<Command> answer_to(CLI::App& root, int argc, const char* const* argv) {
    try {
        root.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& e) {
        const std::vector<std::string> unknown = root.remaining(true);
        if (e.get_exit_code() != 0)
            throw UsageError{(unknown.empty() ? std::string{e.what()} : in_words(unknown, root)) +
                             " (see: " + typed_name_of(leaf_of(root)) + " --help)"};
        std::ostringstream text;
        root.exit(e, text, text);
        return command_of(Answered{.common = {}, .text = text.str()}, "cannot answer");
    }
}

void take_settings(CLI::App& root, const SettingsChoice& choice, const Environment& environment) {
    CLI::App& leaf = leaf_of(root);
    if (!listens(leaf)) return;
    give(that_concern(leaf, settings_here(choice, environment)), leaf);
}

Command chosen(const std::vector<Branch>& branches, const std::string& example) {
    const auto branch = std::ranges::find_if(branches, [](const Branch& b) { return b.app->parsed(); });
    if (branch != branches.end()) return branch->understood();
    throw UsageError{"a command is expected, such as: " + example +
                     " (see: " + example.substr(0, example.rfind(' ')) + " --help)"};
}

ExitCode execute(const Answered& answered) {
    std::cout << answered.text;
    return ExitCode::proven;
}

}  // namespace zproof
