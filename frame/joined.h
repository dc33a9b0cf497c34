/// Words in a row.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace zproof {

/// word(item) of every item, with `between` between them.
template <class Items, class Word = std::identity>
std::string joined(const Items& items, std::string_view between = ", ", const Word& word = {}) {
    std::string text;
    for (const auto& item : items) {
        if (!text.empty()) text += between;
        text += std::invoke(word, item);
    }
    return text;
}

}  // namespace zproof
