/// The line of a command's text that -q leaves.
#pragma once

#include <string>

namespace zproof {

/// Each with its end of line.
std::string first_line(const std::string& text);
std::string last_line(const std::string& text);

}  // namespace zproof
