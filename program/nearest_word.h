/// "Did you mean ...?"
#pragma once

#include <span>
#include <string>

namespace zproof {

/// "; did you mean 'known'?" where a known word is at most two edits (insert, delete, replace) away, else "".
std::string did_you_mean(const std::string& word, std::span<const std::string> known);

/// What a word should have named.
struct KnownWords {
    std::span<const std::string> words;
    std::string place;  ///< where it was typed: "--region"
    std::string kind;   ///< "region"
};

/// Throws UsageError, with the nearest and all known words, where the word is none of them.
void require_known(const std::string& word, const KnownWords& known);

}  // namespace zproof
