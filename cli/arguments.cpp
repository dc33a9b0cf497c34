#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <sstream>
#include <thread>

#include "cli/command_line/misspelling.h"
#include "cli/command_line/tree.h"
#include "cli/plan/typed_out.h"
#include "cli/settings/apply.h"
#include "cli/usage_error.h"
#include "frame/printable.h"
#include "scenes/random_scenes.h"

namespace zproof {
namespace {

/// The command that was parsed, the last of "filters run".
CLI::App& leaf_of(CLI::App& app) {
    for (CLI::App* command : app.get_subcommands())
        if (command->parsed()) return leaf_of(*command);
    return app;
}

/// What was not typed is taken from environment, profile and file.
void take_settings(CommandTree& tree, const Environment& environment) {
    CLI::App& leaf = leaf_of(tree.root());
    if (!listens(leaf)) return;
    give(that_concern(leaf, settings_here(tree.words().settings, environment)), leaf);
}

/// "zproof filters run".
std::string typed_name_of(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? "zproof" : typed_name_of(*parent) + " " + command.get_name();
}

/// CLI11 throws both for mistakes and for --help; only the former are errors of the user.
Answered answer_or_throw(CLI::App& app, const CLI::ParseError& e) {
    if (e.get_exit_code() != 0)
        throw UsageError{e.what() + misspelling_in(app) + " (see: " + typed_name_of(leaf_of(app)) +
                         " --help)"};
    std::ostringstream text;
    app.exit(e, text, text);
    return {.common = {}, .text = text.str()};
}

}  // namespace

namespace {

template <class Arguments>
const CommonArguments& common_in(const Arguments& arguments) {
    if constexpr (requires { arguments.report.common; })
        return arguments.report.common;
    else
        return arguments.common;
}

}  // namespace

const CommonArguments& common_of(const Command& command) {
    return std::visit([](const auto& arguments) -> const CommonArguments& { return common_in(arguments); },
                      command);
}

std::vector<std::string> RandomChoice::words() const {
    std::vector<std::string> words;
    for (std::uint64_t number = 0; number < count; ++number)
        words.push_back(word_of(random_scene(kind, seed, number)));
    return words;
}

int available_threads() { return std::clamp(int(std::thread::hardware_concurrency()), 1, 1024); }

RunArguments planned_run(const std::vector<std::string>& argv) {
    std::vector<const char*> words{"zproof"};
    for (const std::string& word : argv) words.push_back(word.c_str());
    const Environment nothing = [](const std::string&) -> const char* { return nullptr; };
    return std::get<RunArguments>(parse_command_line(int(words.size()), words.data(), nothing));
}

namespace {

/// The run that is planned for, with the settings of this profile.
RunWords words_of_run(int argc, const char* const* argv, const Environment& environment,
                      const std::string& profile) {
    CommandTree tree;
    tree.root().parse(argc, argv);
    tree.words().settings.profile = profile;
    take_settings(tree, environment);
    return {profile, run_typed_out(leaf_of(tree.root()))};
}

/// One per profile that was named. A plan of one run needs no name for it.
std::vector<RunWords> planned_runs(int argc, const char* const* argv, const Environment& environment,
                                   const std::vector<std::string>& profiles) {
    if (profiles.empty()) return {words_of_run(argc, argv, environment, "")};
    std::vector<RunWords> runs;
    for (const std::string& profile : profiles)
        runs.push_back(words_of_run(argc, argv, environment, profile));
    if (runs.size() == 1) runs.front().name.clear();
    return runs;
}

}  // namespace

Command parse_command_line(int argc, const char* const* argv, const Environment& environment) {
    CommandTree tree;
    CommandWords& words = tree.words();
    const std::vector<std::string> typed{argv + 1, argv + argc};
    words.filters.run.typed = words.study.typed = words.fit.typed = shell_line(typed);
    for (ReportArguments* report : {&words.run.report, &words.compare.report}) {
        report->argv = typed;
        report->typed = shell_line(typed);
    }
    try {
        tree.root().parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return answer_or_throw(tree.root(), e);
    }
    words.environment = environment;
    if (leaf_of(tree.root()).get_name() == "plan")
        words.plan.runs = planned_runs(argc, argv, environment, words.plan_profiles);
    else
        take_settings(tree, environment);
    return tree.chosen();
}

namespace {

/// $'...', in which every byte is seen.
std::string quoted_with_escapes(const std::string& word) {
    std::string quoted = "$'";
    for (const char c : word) {
        const auto byte = std::uint8_t(c);
        const bool is_plain = byte >= 0x20 && byte < 0x7F && c != '\'' && c != '\\';
        constexpr const char* digits = "0123456789abcdef";
        quoted += is_plain ? std::string{c} : std::string{'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
    return quoted + "'";
}

}  // namespace

std::string shell_quoted(const std::string& word) {
    constexpr const char* harmless =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=:,+@%";
    if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
    if (one_line(word) != word) return quoted_with_escapes(word);
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return quoted + "'";
}

std::string shell_line(const std::vector<std::string>& words) {
    std::string line = "zproof";
    for (const std::string& word : words) line += " " + shell_quoted(word);
    return line;
}

}  // namespace zproof
