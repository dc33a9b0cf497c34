#include "program/command_line/misspelling.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "program/nearest_word.h"

namespace zproof {
namespace {

/// The command whose words were being read.
const CLI::App& innermost(const CLI::App& app) {
    const std::vector<CLI::App*> typed = app.get_subcommands();
    return typed.empty() ? app : innermost(*typed.back());
}

std::vector<std::string> known_to(const CLI::App& app) {
    std::vector<std::string> words;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    for (const CLI::App* command : app.get_subcommands(std::function<bool(const CLI::App*)>{}))
        words.push_back(command->get_name());
    return words;
}

}  // namespace

std::string misspelling_in(const CLI::App& root) {
    const std::vector<std::string> unknown = root.remaining(true);
    if (unknown.empty()) return "";
    return did_you_mean(unknown.front().substr(0, unknown.front().find('=')), known_to(innermost(root)));
}

}  // namespace zproof
