#include "frame/printable.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace zproof {

namespace {

/// Length of the well-formed UTF-8 sequence at the start of text (Unicode 15, table 3-7), 0 where there is
/// none.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? unsigned(std::uint8_t(text[i])) : 0u; };
    const auto within = [&](std::size_t i, unsigned low, unsigned high) {
        return byte(i) >= low && byte(i) <= high;
    };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead <= 0xDF) return within(1, 0x80, 0xBF) ? 2 : 0;
    if (lead >= 0xE0 && lead <= 0xEF) {
        const unsigned low = lead == 0xE0 ? 0xA0 : 0x80, high = lead == 0xED ? 0x9F : 0xBF;
        return within(1, low, high) && within(2, 0x80, 0xBF) ? 3 : 0;
    }
    if (lead >= 0xF0 && lead <= 0xF4) {
        const unsigned low = lead == 0xF0 ? 0x90 : 0x80, high = lead == 0xF4 ? 0x8F : 0xBF;
        return within(1, low, high) && within(2, 0x80, 0xBF) && within(3, 0x80, 0xBF) ? 4 : 0;
    }
    return 0;
}

std::uint32_t code_point(std::string_view sequence) {
    const auto lead = std::uint8_t(sequence[0]);
    if (sequence.size() == 1) return lead;
    std::uint32_t code = lead & (0xFFu >> (sequence.size() + 1));
    for (const char c : sequence.substr(1)) code = code << 6 | (std::uint8_t(c) & 0x3F);
    return code;
}

struct CodeRange {
    std::uint32_t first, last;
};

/// Unicode 15's categories Cc, Cf, Zl and Zp but newline and tab; variation selectors, fillers that have no
/// glyph, and what XML 1.0 forbids.
constexpr auto unseen = std::to_array<CodeRange>({
    {0x0, 0x8},         {0xB, 0x1F},        {0x7F, 0x9F},       {0xAD, 0xAD},       {0x34F, 0x34F},
    {0x600, 0x605},     {0x61C, 0x61C},     {0x6DD, 0x6DD},     {0x70F, 0x70F},     {0x890, 0x891},
    {0x8E2, 0x8E2},     {0x115F, 0x1160},   {0x17B4, 0x17B5},   {0x180B, 0x180F},   {0x200B, 0x200F},
    {0x2028, 0x202E},   {0x2060, 0x206F},   {0x3164, 0x3164},   {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},
    {0xFFA0, 0xFFA0},   {0xFFF0, 0xFFFB},   {0xFFFE, 0xFFFF},   {0x110BD, 0x110BD}, {0x110CD, 0x110CD},
    {0x13430, 0x1343F}, {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF},
});

bool is_unseen(std::uint32_t code) {
    return std::ranges::any_of(unseen, [&](CodeRange r) { return code >= r.first && code <= r.last; });
}

std::string hex(std::uint32_t value, int digits) {
    std::string text;
    while (digits-- > 0) text += "0123456789abcdef"[value >> 4 * digits & 0xF];
    return text;
}

std::string escape_of(std::uint32_t code) {
    if (code < 0x80) return "\\x" + hex(code, 2);
    return code < 0x10000 ? "\\u" + hex(code, 4) : "\\U" + hex(code, 8);
}

/// What the first sequence of the text becomes; it is taken from the text.
std::string next_printable(std::string_view& text) {
    const std::size_t length = std::max<std::size_t>(sequence_length(text), 1);
    const bool is_text = sequence_length(text) > 0;
    const std::string_view sequence = text.substr(0, length);
    text.remove_prefix(length);
    if (!is_text) return "\\x" + hex(std::uint8_t(sequence[0]), 2);
    const std::uint32_t code = code_point(sequence);
    return is_unseen(code) ? escape_of(code) : std::string(sequence);
}

/// Goes back from a place within a sequence to its beginning.
std::size_t at_a_character(std::string_view text, std::size_t at) {
    while (at > 0 && at < text.size() && (std::uint8_t(text[at]) & 0xC0) == 0x80) --at;
    return at;
}

constexpr std::string_view left_out = "...";

/// At most `most` bytes, with the middle left out where there are more.
std::string without_middle(std::string_view text, std::size_t most) {
    if (text.size() <= most) return std::string(text);
    const std::size_t kept = most - left_out.size();
    std::size_t tail = text.size() - kept / 2;
    while (tail < text.size() && (std::uint8_t(text[tail]) & 0xC0) == 0x80) ++tail;
    return std::string(text.substr(0, at_a_character(text, kept - kept / 2)))
        .append(left_out)
        .append(text.substr(tail));
}

/// Every word of the line with at most `most` bytes.
std::string with_short_words(std::string_view line, std::size_t most) {
    std::string text;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        text += (at == 0 ? "" : " ") + without_middle(line.substr(at, end - at), most);
        at = end + 1;
    }
    return text;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string safe;
    while (!text.empty()) safe += next_printable(text);
    return safe;
}

std::string one_line(std::string_view text) {
    std::string line = printable(text);
    for (char& c : line)
        if (c == '\n' || c == '\t') c = ' ';
    return line;
}

std::string shortened(std::string_view text, std::size_t most) {
    const std::string line = one_line(text);
    if (line.size() <= most) return line;
    for (const std::size_t longest_word : {most / 3, most / 5, most / 8})
        if (std::string shorter = with_short_words(line, longest_word); shorter.size() <= most)
            return shorter;
    return without_middle(with_short_words(line, most / 5), most);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n') + 1); }

std::string last_line(const std::string& text) {
    const std::size_t end = text.rfind('\n', text.size() - 2);  // of the line before
    return end == std::string::npos ? text : text.substr(end + 1);
}

}  // namespace zproof
