#include "cli/plan/explicit_words.h"

#include <CLI/CLI.hpp>

#include "cli/gate/gate.h"
#include "program/settings/apply.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

/// It bears on the judgement: neither of the machine nor of the plan.
bool is_stated(const CLI::Option& option) {
    return !is_of_the_machine(option) && option.get_group() != plan_options;
}

bool is_flag(const CLI::Option& option) { return option.get_expected_max() == 0; }

void type_out(const CLI::Option& option, std::vector<std::string>& words) {
    for (const std::string& result : option.results())
        if (option.get_positional())
            words.push_back(result);
        else
            words.push_back(option.get_name() + (is_flag(option) && result == "true" ? "" : "=" + result));
}

}  // namespace

std::vector<std::string> explicit_run_words(const CLI::App& app) {
    std::vector<std::string> words{"run"};
    for (const CLI::Option* option : app.get_options())
        if (is_stated(*option)) type_out(*option, words);
    if (app.get_option("--now")->count() == 0) words.push_back("--now=" + in_words(this_day()));
    words.emplace_back("--config=none");
    return words;
}

void require_machine_words(const CLI::App& run) {
    for (const CLI::Option* option : run.get_options())
        if (option->count() > 0 && !is_of_the_machine(*option))
            throw UsageError{option->get_name() + ": the plan states it; leave it out, or make another plan"};
}

}  // namespace zproof
