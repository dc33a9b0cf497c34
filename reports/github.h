/// Annotations for GitHub Actions: lines that its runner reads from a step's output.
#pragma once

#include <cstddef>
#include <string>

#include "reports/results.h"

namespace zproof {

/// GitHub shows so many errors and so many warnings of a step, and drops the rest without a word.
inline constexpr std::size_t most_annotations = 10;

/// "::error file=...,line=1,title=...::message" for expired waivers and every view that fails, the worst
/// first; "::warning ..." for other waivers that need a hand. Of each kind at most most_annotations, then a
/// plain line that counts the rest. Empty where there is nothing to say.
std::string to_github(const Results& results);

/// The text as GitHub wants it in a message, and in a property ("title"): % \r \n, and in properties : and ,
/// are percent-encoded.
std::string github_message(const std::string& text);
std::string github_property(const std::string& text);

}  // namespace zproof
