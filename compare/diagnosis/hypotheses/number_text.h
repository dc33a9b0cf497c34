/// A number in few digits, for descriptions.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace zproof {

inline std::string number_text(double number, int digits) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits).ptr;
    return {text.data(), end};
}

}  // namespace zproof
