/// From words to a command: what the programs of zproof have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/command.h"
#include "program/settings/sources.h"

namespace CLI {
class App;
}

namespace zproof {

/// The command that was parsed, the last of "filters run".
CLI::App& leaf_of(CLI::App& app);

/// Reads the words. CLI11 answers --help and --version by itself: then that is the command. Throws UsageError
/// for mistakes, with what was probably meant.
std::optional<Command> answer_to(CLI::App& root, int argc, const char* const* argv);

/// What was not typed is taken from environment, profile and file.
void take_settings(CLI::App& root, const SettingsChoice& choice, const Environment& environment);

/// The command of the branch that was parsed. Throws UsageError, with the example, where none was.
Command chosen(const std::vector<Branch>& branches, const std::string& example);

}  // namespace zproof
