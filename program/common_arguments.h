/// What every command is asked with: -j, --color, -q, -o (docs/cli.md, "Four options of every command").
#pragma once

#include <filesystem>
#include <functional>

#include "program/settings.h"

namespace zproof {

enum class ColourMode {
    automatic,  ///< on a terminal, unless NO_COLOR is set or TERM is "dumb"
    always,
    never,
};

enum class Detail {
    verdict,  ///< -q: the result only
    table,    ///< what led to it, too
    times,    ///< the same, and where the time went
};

/// What a command makes, which is what -o names.
enum class Output {
    text,    ///< what it prints, in a file instead
    file,    ///< one file
    folder,  ///< several files, in this folder
};

struct CommonArguments {
    Output output = Output::text;
    std::filesystem::path out = {};     ///< of text: empty or "-" is stdout
    int threads = available_threads();  ///< at most so many work; no bit of a result depends on it
    ColourMode colour = ColourMode::automatic;
    Detail detail = Detail::table;
    ProgressStyle progress = ProgressStyle::automatic;

    bool is_quiet() const { return detail == Detail::verdict; }
    bool is_printed_to_file() const { return output == Output::text && !out.empty() && out != "-"; }
};

/// How progress is told: -q has the last word, whatever a setting says of it.
ProgressStyle progress_of(const CommonArguments& common);
/// The style beside results that are lines and tell as much: a bar on a terminal, else nothing.
ProgressStyle progress_beside_lines(const CommonArguments& common);

/// May what is printed hold colours?
bool wants_colours(const CommonArguments& common);

/// Does the work in an arena of so many threads, and lets no library take more.
void on_threads(int count, const std::function<void()>& work);

}  // namespace zproof
