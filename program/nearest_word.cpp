#include "program/nearest_word.h"

#include <algorithm>

#include "program/usage_error.h"

namespace zproof {

void require_known(const std::string& word, const KnownWords& known) {
    if (std::ranges::find(known.words, word) != known.words.end()) return;
    throw UsageError{known.place + " '" + word + "': no such " + known.kind +
                     did_you_mean_or_all(word, known.words)};
}

}  // namespace zproof
