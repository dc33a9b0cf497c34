/// The word that was meant by one that nobody knows.
#pragma once

#include <span>
#include <string>

namespace zproof {

/// "; did you mean 'known'?" where a known word is at most two edits (insert, delete, replace) away, or holds
/// the word as a part; else "".
std::string did_you_mean(const std::string& word, std::span<const std::string> known);

/// The same, and where there is no such word "; allowed here: a, b, c".
std::string did_you_mean_or_all(const std::string& word, std::span<const std::string> known);

}  // namespace zproof
