#include "program/shell_line.h"

#include <cstdint>

#include "frame/printable.h"

namespace zproof {

namespace {

/// $'...', in which every byte is seen.
std::string quoted_with_escapes(const std::string& word) {
    std::string quoted = "$'";
    for (const char c : word) {
        const auto byte = std::uint8_t(c);
        const bool is_plain = byte >= 0x20 && byte < 0x7F && c != '\'' && c != '\\';
        constexpr const char* digits = "0123456789abcdef";
        quoted += is_plain ? std::string{c} : std::string{'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
    return quoted + "'";
}

}  // namespace

std::string shell_quoted(const std::string& word) {
    constexpr const char* harmless =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=:,+@%";
    if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
    if (one_line(word) != word) return quoted_with_escapes(word);
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return quoted + "'";
}

std::string shell_line(const std::vector<std::string>& words) {
    std::string line = "zproof";
    for (const std::string& word : words) line += " " + shell_quoted(word);
    return line;
}

}  // namespace zproof
