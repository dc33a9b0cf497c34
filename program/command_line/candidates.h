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

/// A kind of values that a program can list: the type name of an option, or a positional's own name.
struct ValueKind {
    const char* name;                                           ///< "SCENE", "RENDERERS"
    Candidates (*candidates)(const std::string& command_path);  ///< of "run", "filters check"
};

/// A program's table of them.
using ValueKinds = std::span<const ValueKind>;

}  // namespace zproof
