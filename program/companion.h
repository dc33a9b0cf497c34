/// The programs beside zproof. Each is typed as a command of it: "zproof filters run".
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "program/command_line/outline.h"

namespace zproof {

struct Companion {
    const char *command, *purpose;  ///< "filters"; a line for --help
};

/// All of them, in the order of --help.
std::span<const Companion> companions();
/// The one of this name; null: there is none.
const Companion* companion_named(const std::string& command);

/// "zproof-filters" beside this program. Nothing where it is not there.
std::optional<std::filesystem::path> program_of(const Companion& companion);

/// Goes on as the companion, asked these words. Throws std::runtime_error, with how to come by it, where it
/// is not there.
[[noreturn]] void become(const Companion& companion, std::span<const char* const> words);

/// Runs it to its end, with this program's own output. Its exit status; 128 and the signal, where one ended
/// it. Throws as become().
int status_of(const Companion& companion, const std::vector<std::string>& words);

/// What its command line can parse; where it is not there, its name and purpose.
OutlineCommand outline_of(const Companion& companion);

}  // namespace zproof
