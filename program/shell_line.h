/// Command lines as a POSIX shell must be given them.
#pragma once

#include <string>
#include <vector>

namespace zproof {

std::string shell_quoted(const std::string& word);

/// "zproof" and the words, each quoted as it must be.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace zproof
