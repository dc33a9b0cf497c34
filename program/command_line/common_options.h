/// Options that commands of several programs have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "program/common_arguments.h"

namespace zproof {

/// The heading in the help of options that a plan does not state, but leaves to each machine.
inline constexpr const char* machine_options = "Output, settings and machine";

/// Binds a word from a fixed list, which must outlive the app; the help shows the list, an unknown word is a
/// usage error.
template <class T>
CLI::Option* add_choice(CLI::App& app, const std::string& option, T& value,
                        const std::map<std::string, T>& choices) {
    std::vector<std::string> words;
    words.reserve(choices.size());
    for (const auto& [word, meaning] : choices) words.push_back(word);
    return app
        .add_option_function<std::string>(option, [&](const std::string& word) { value = choices.at(word); })
        ->check(CLI::IsMember(words))
        ->default_str("auto");
}

/// -j, --color, -q and -o: of every command, and stated here alone. `made`: what -o names, where it is not
/// what is printed.
void add_common(CLI::App& app, CommonArguments& common, const std::string& made = "");
void add_progress(CLI::App& app, CommonArguments& common);  ///< --progress
/// --isa; holds for the process as soon as it is read.
void add_isa(CLI::App& app);

}  // namespace zproof
