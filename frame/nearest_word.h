/// "Did you mean ...?"
#pragma once

#include <span>
#include <string>

namespace zproof {

/// "; did you mean 'known'?" where a known word is at most two edits (insert, delete, replace) away, else "".
std::string did_you_mean(const std::string& word, std::span<const std::string> known);

}  // namespace zproof
