#include "reports/wording.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

namespace zproof {

namespace {

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

std::string sample_words(std::uint64_t pixels, std::uint64_t of_pixels, std::uint64_t seed) {
    return grouped(pixels) + " of " + grouped(of_pixels) + " pixels, chosen by seed " + std::to_string(seed);
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

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string safe = "\"";
    for (const char c : text) safe += c == '"' ? std::string{"\"\""} : std::string{c};
    return safe + "\"";
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
