/// A word that must be known.
#pragma once

#include <span>
#include <string>

#include "frame/nearest_word.h"

namespace zproof {

/// What a word should have named.
struct KnownWords {
    std::span<const std::string> words;
    std::string place;  ///< where it was typed: "--region"
    std::string kind;   ///< "region"
};

/// Throws UsageError, with the nearest and all known words, where the word is none of them.
void require_known(const std::string& word, const KnownWords& known);

}  // namespace zproof
