#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <cstdint>

#include "cli/command_line/tree.h"
#include "cli/plan/explicit_words.h"
#include "program/command_line/parsing.h"
#include "program/shell_line.h"
#include "scenes/random_scenes.h"

namespace zproof {

std::vector<std::string> RandomChoice::words() const {
    std::vector<std::string> words;
    for (std::uint64_t number = 0; number < count; ++number)
        words.push_back(word_of(random_scene(kind, seed, number)));
    return words;
}

RunArguments planned_run(const std::vector<std::string>& argv) {
    std::vector<const char*> words{"zproof"};
    for (const std::string& word : argv) words.push_back(word.c_str());
    const Environment nothing = [](const std::string&) -> const char* { return nullptr; };
    return std::any_cast<RunArguments>(
        parse_command_line(int(words.size()), words.data(), nothing).arguments);
}

namespace {

/// The run that is planned for, with the settings of this profile.
RunWords words_of_run(int argc, const char* const* argv, const Environment& environment,
                      const std::string& profile) {
    CommandTree tree;
    tree.root().parse(argc, argv);
    tree.words().settings.profile = profile;
    take_settings(tree.root(), tree.words().settings, environment);
    return {profile, explicit_run_words(leaf_of(tree.root()))};
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
    words.fit.typed = shell_line(typed);
    for (ReportArguments* report : {&words.run.report, &words.compare.report, &words.conformance.report}) {
        report->argv = typed;
        report->typed = shell_line(typed);
    }
    if (const auto answer = answer_to(tree.root(), argc, argv)) return *answer;
    words.environment = environment;
    if (leaf_of(tree.root()).get_name() == "plan")
        words.plan.runs = planned_runs(argc, argv, environment, words.plan_profiles);
    else
        take_settings(tree.root(), words.settings, environment);
    return tree.chosen();
}

}  // namespace zproof
