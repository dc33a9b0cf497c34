/// What a shell can offer where a value is to be typed.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line/outline.h"

namespace zproof {

/// What may stand there beside the words.
enum class Paths { none, files, folders };

enum class Listing {
    single,    ///< one of the words
    by_comma,  ///< several, with commas between them
};

struct Candidates {
    std::vector<std::string> words;  ///< letters, digits and "-_.,=": a shell takes none of them apart
    Paths paths = Paths::none;
    Listing listing = Listing::single;

    bool operator==(const Candidates&) const = default;
};

/// The candidates for a value of this option or positional of this command: its choices where it has a list
/// of them; else what its name stands for (a scene, a renderer, a filter, a pixel class ...); nothing for
/// numbers; files for all else.
Candidates candidates_for(const OutlineCommand& command, const OutlineOption& option);

}  // namespace zproof
