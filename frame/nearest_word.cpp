#include "frame/nearest_word.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace zproof {
namespace {

/// Edits (insert, delete, replace) between two words: Levenshtein's distance.
std::size_t edits_between(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string did_you_mean(const std::string& word, std::span<const std::string> known) {
    const auto edits = [&](const std::string& candidate) { return edits_between(word, candidate); };
    const auto nearest = std::ranges::min_element(known, {}, edits);
    return nearest != known.end() && edits(*nearest) <= 2 ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace zproof
