#include "program/settings/apply.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "program/command_line/common_options.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

bool has(const CLI::App& app, const std::string& option) {
    return app.get_option_no_throw(option) != nullptr;
}

/// A shard of a plan, which states all that bears on the judgement.
bool has_plan(const CLI::App& app) {
    const CLI::Option* plan = app.get_option_no_throw("--plan");
    return has(app, "--shard") && plan != nullptr && plan->count() > 0;
}

/// It is about one frame and was told whose, as by the commands in reports: those mean the same everywhere.
bool is_told_whose_frame(const CLI::App& app) {
    if (has(app, "--report") || !has(app, "--renderer") || !has(app, "--candidate")) return false;
    return app.count("--renderer") + app.count("--candidate") > 0;
}

/// A command that can be told a settings file takes all settings; one that renders, those of any program. A
/// word that has to be typed comes from nowhere else, and one folder for reports is that of commands that
/// write them.
bool concerns(const CLI::App& app, const std::string& setting) {
    const CLI::Option* option = app.get_option_no_throw(option_name(setting));
    if (option == nullptr || option->get_required()) return false;
    const auto for_all = {"threads", "isa", "color", "progress"};
    if (std::ranges::find(for_all, setting) != for_all.end() && has(app, "--isa")) return true;
    if (!has(app, "--config") || is_told_whose_frame(app)) return false;
    if (has_plan(app) && !is_of_the_machine(*option)) return false;
    return setting != "out" || has(app, "--report");
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

bool is_of_the_machine(const CLI::Option& option) { return option.get_group() == machine_options; }

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
