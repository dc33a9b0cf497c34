#include "program/settings/apply.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr std::array machine_options{"--help",
                                     "--plan",
                                     "--shard",
                                     "--empty-shard",
                                     "--exit-zero",
                                     "--out",
                                     "--threads",
                                     "--color",
                                     "--quiet",
                                     "--progress",
                                     "--times",
                                     "--isa",
                                     "--report",
                                     "--config",
                                     "--profile",
                                     "--reference-cache",
                                     "--reference-cache-size"};
bool is_of_waive(const CLI::App& app) {
    return app.get_parent() != nullptr && app.get_parent()->get_name() == "waive";
}

bool bears_on_all(const CLI::App& app) {
    const std::string name = app.get_name();
    const CLI::App* parent = app.get_parent();
    return name == "compare" || name == "merge" || name == "plan" || is_of_waive(app) ||
           (name == "run" && parent != nullptr && parent->get_name() == "zproof");
}

/// A shard of a plan, which states all that bears on the judgement.
bool has_plan(const CLI::App& app) {
    const CLI::Option* plan = app.get_option_no_throw("--plan");
    return app.get_name() == "run" && plan != nullptr && plan->count() > 0;
}

bool concerns(const CLI::App& app, const std::string& setting) {
    if (app.get_option_no_throw(option_name(setting)) == nullptr) return false;
    const auto for_all = {"threads", "isa", "color", "progress"};
    const bool renders = app.get_option_no_throw("--isa") != nullptr;
    if (std::ranges::find(for_all, setting) != for_all.end()) return renders || bears_on_all(app);
    const std::string command = app.get_name();
    if (has_plan(app) && !is_of_the_machine(option_name(setting))) return false;
    if (setting == "out") return bears_on_all(app) && !is_of_waive(app) && command != "plan";  // of reports
    return bears_on_all(app) && (setting != "scenes" || command == "run" || command == "plan");
}

void give_to(CLI::Option& option, const SettingValue& request) {
    try {
        for (const std::string& word : request.words) option.add_result(word);
        option.run_callback();
    } catch (const CLI::Error& e) {
        throw UsageError{request.origin + ": " + e.what()};
    } catch (const UsageError& e) {
        throw UsageError{request.origin + ": " + e.what()};
    }
}

}  // namespace

bool is_of_the_machine(const std::string& option_name) {
    return std::ranges::find(machine_options, option_name) != machine_options.end();
}

void give(const SettingValues& assignments, CLI::App& app) {
    for (const SettingValue& request : assignments) {
        CLI::Option* option = app.get_option_no_throw(option_name(request.name));
        if (option != nullptr && option->count() == 0) give_to(*option, request);
    }
}

SettingValues that_concern(const CLI::App& app, const SettingValues& assignments) {
    SettingValues some = assignments;
    std::erase_if(some, [&](const SettingValue& one) { return !concerns(app, one.name); });
    return some;
}

bool listens(const CLI::App& app) {
    return std::ranges::any_of(known_settings(),
                               [&](const Setting& setting) { return concerns(app, setting.name); });
}

}  // namespace zproof
