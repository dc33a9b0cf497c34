/// What a shell can offer where a value is to be typed.
#pragma once

#include <span>
#include <string>
#include <vector>

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

/// What one name of an option or positional stands for wherever it occurs: a scene, a renderer, a pixel
/// class.
struct NameMeaning {
    const char* name;                                           ///< "SCENE", "--renderer"
    Candidates (*candidates)(const std::string& command_path);  ///< of "run", "filters check"
};

/// A program's table of them.
using NameMeanings = std::span<const NameMeaning>;

/// Those of every program: --isa, and names for which there is nothing to offer.
NameMeanings common_meanings();

}  // namespace zproof
