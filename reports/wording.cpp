#include "reports/wording.h"

namespace zproof {

std::string sample_words(std::uint64_t pixels, std::uint64_t of_pixels, std::uint64_t seed) {
    return grouped(pixels) + " of " + grouped(of_pixels) + " pixels, chosen by seed " + std::to_string(seed);
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
