#include "reports/base64.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace zproof {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

using Pair = std::array<char, 2>;

/// What becomes of twelve bits.
constexpr std::array<Pair, 4096> pairs = [] {
    std::array<Pair, 4096> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = {alphabet[i >> 6], alphabet[i & 63]};
    return all;
}();

std::uint32_t byte_at(std::string_view bytes, std::size_t i) { return std::uint8_t(bytes[i]); }

}  // namespace

std::string base64(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    char* to = text.data();
    std::size_t i = 0;
    for (; i + 3 <= bytes.size(); i += 3, to += 4) {
        const std::uint32_t group =
            byte_at(bytes, i) << 16 | byte_at(bytes, i + 1) << 8 | byte_at(bytes, i + 2);
        std::memcpy(to, pairs[group >> 12].data(), 2);
        std::memcpy(to + 2, pairs[group & 4095].data(), 2);
    }
    const std::size_t rest = bytes.size() - i;
    if (rest == 0) return text;
    const std::uint32_t group = byte_at(bytes, i) << 16 | (rest > 1 ? byte_at(bytes, i + 1) << 8 : 0u);
    for (std::size_t k = 0; k <= rest; ++k) to[k] = alphabet[group >> (18 - 6 * k) & 63];
    return text;
}

}  // namespace zproof
