/// Text of strangers, made safe to show: on a terminal, in a message, in a page.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace zproof {

/// Well-formed UTF-8 in which every character is seen and none reorders the others. Control characters except
/// newline and tab, marks of direction and of no width become "\x1b" or "\u202e"; bytes that are no UTF-8
/// become "\xb6".
std::string printable(std::string_view text);

/// The text on a single line: newlines and tabs of printable(text) become blanks.
std::string one_line(std::string_view text);

/// At most `most` bytes of one_line(text), for most >= 100: the longest words lose their middles, then the
/// line does.
std::string shortened(std::string_view text, std::size_t most);

/// An error or progress line has fewer bytes, its newline counted.
constexpr std::size_t longest_line_bytes = 300;

/// Each with its end of line.
std::string first_line(const std::string& text);
std::string last_line(const std::string& text);

}  // namespace zproof
