/// A word that must be one of some.
#pragma once

#include <span>
#include <string>

#include "frame/did_you_mean.h"

namespace zproof {

/// What a word should have named.
struct KnownWords {
    std::span<const std::string> words;
    std::string place;  ///< where it was typed: "--region"
    std::string kind;   ///< "region"
};

/// Throws UsageError, with the nearest of the known words or with all, where the word is none of them.
void require_known(const std::string& word, const KnownWords& known);

}  // namespace zproof
