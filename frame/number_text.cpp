#include "frame/number_text.h"

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

std::string fixed(double value, int decimals) {
    return std::isfinite(value) ? digits(value, std::chars_format::fixed, decimals) : shortest(value);
}

std::string with_digits(double value, int count) {
    return std::isfinite(value) ? digits(value, std::chars_format::general, count) : shortest(value);
}

std::string rounded(double value) { return with_digits(value, 3); }

std::string size_text(std::int64_t width, std::int64_t height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace zproof
