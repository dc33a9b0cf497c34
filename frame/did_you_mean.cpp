#include "frame/did_you_mean.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "frame/joined.h"

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
    constexpr std::size_t most_edits = 2, shortest_part = 4;
    const auto edits = [&](const std::string& candidate) { return edits_between(word, candidate); };
    const auto holds_it = [&](const std::string& candidate) {
        return word.size() >= shortest_part && candidate.find(word) != std::string::npos;
    };
    auto meant = std::ranges::min_element(known, {}, edits);
    if (meant != known.end() && edits(*meant) > most_edits) meant = std::ranges::find_if(known, holds_it);
    return meant == known.end() ? "" : "; did you mean '" + *meant + "'?";
}

std::string did_you_mean_or_all(const std::string& word, std::span<const std::string> known) {
    const std::string meant = did_you_mean(word, known);
    return meant.empty() ? "; allowed here: " + joined(known) : meant;
}

}  // namespace zproof
