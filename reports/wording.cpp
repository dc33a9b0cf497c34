#include "reports/wording.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

namespace zproof {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

template <class... Format>
std::string digits(Format... format) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), format...).ptr;
    return {buffer.data(), end};
}

template <class Real>
std::string shortest_of(Real value) {
    if (std::isnan(value)) return "nan";  // to_chars would tell -nan apart
    return digits(value);
}

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

/// C0 and C1 controls, and the two non-characters that XML 1.0 forbids.
bool is_forbidden(std::string_view sequence) {
    if (sequence.size() == 1) {
        const char c = sequence[0];
        return (c >= 0 && c < 0x20 && c != '\n' && c != '\t') || c == 0x7F;
    }
    return (sequence.size() == 2 && sequence[0] == '\xC2' && std::uint8_t(sequence[1]) < 0xA0) ||
           sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF";
}

}  // namespace

std::string shortest(double value) { return shortest_of(value); }
std::string shortest(float value) { return shortest_of(value); }

std::string hex_bits(float value) {
    std::string text = digits(std::bit_cast<std::uint32_t>(value), 16);
    return "0x" + std::string(8 - text.size(), '0') + text;
}

std::string grouped(std::uint64_t value) {
    std::string text = std::to_string(value);
    for (int i = int(text.size()) - 3; i > 0; i -= 3) text.insert(std::size_t(i), ",");
    return text;
}

std::string fixed(double value, int decimals) {
    return std::isfinite(value) ? digits(value, std::chars_format::fixed, decimals) : shortest(value);
}

std::string rounded(double value) {
    return std::isfinite(value) ? digits(value, std::chars_format::general, 3) : shortest(value);
}

std::string id_text(PrimitiveId id) {
    return id == PrimitiveId::none ? "none" : std::to_string(static_cast<std::uint32_t>(id));
}

std::string counted(std::uint64_t count, std::string_view noun) {
    return grouped(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string printable(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        const std::string_view sequence = text.substr(0, length);
        safe += length == 0 || is_forbidden(sequence) ? replacement : sequence;
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return safe;
}

std::string one_line(std::string_view text) {
    std::string line = printable(text);
    for (char& c : line)
        if (c == '\n' || c == '\t') c = ' ';
    return line;
}

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : printable(text)) switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\'':
                safe += "&#39;";
                break;
            default:
                safe += c;
        }
    return safe;
}

std::string as_url(std::string_view path) {
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
    constexpr std::string_view hex = "0123456789ABCDEF";
    std::string url;
    for (const char c : path) {
        const auto byte = std::uint8_t(c);
        if (plain.find(c) != std::string_view::npos)
            url += c;
        else
            url += {'%', hex[byte >> 4], hex[byte & 15]};
    }
    return url;
}

}  // namespace zproof
