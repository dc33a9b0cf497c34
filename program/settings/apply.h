/// Settings and options meet: what was not typed is taken from elsewhere, by the option's own rules.
#pragma once

#include "program/settings/setting.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace zproof {

/// Gives each option of the command that was not typed the words of its setting, as if they had been. `app`
/// has been parsed. Throws UsageError, which begins with the origin, where a word means nothing to the
/// option.
void give(const SettingValues& assignments, CLI::App& app);

/// Those that this command listens to. What bears on the judgement is for the commands that have --config;
/// threads, isa, color and progress are for these and for every command that renders. A command about one
/// frame that was told whose hears nothing else: so those that a report names (zproof explain ...) mean the
/// same on every machine.
SettingValues that_concern(const CLI::App& app, const SettingValues& assignments);

/// Is there a setting at all that the command listens to?
bool listens(const CLI::App& app);

/// Is this option about the machine that judges, and where and how it tells of it? A plan does not state it.
bool is_of_the_machine(const CLI::Option& option);

}  // namespace zproof
