#include "reports/base64.h"

#include <algorithm>
#include <cstdint>

namespace zproof {

std::string base64(std::string_view bytes) {
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    char* to = text.data();
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t here = std::min<std::size_t>(bytes.size() - i, 3);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < here ? std::uint8_t(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k <= here; ++k) to[k] = alphabet[group >> (18 - 6 * k) & 63];
        to += 4;
    }
    return text;
}

}  // namespace zproof
