#include "cli/published.h"

#include <algorithm>
#include <iostream>

#include "reports/wording.h"

namespace zproof {

void publish(OutputFolder& folder) {
    constexpr std::size_t most_named = 3;
    const std::vector<std::filesystem::path> kept = folder.publish();
    if (kept.empty()) return;
    std::cerr << "zproof: kept " << counted(kept.size(), "file") << " that zproof did not write:";
    for (std::size_t i = 0; i < std::min(kept.size(), most_named); ++i)
        std::cerr << (i == 0 ? " " : ", ") << one_line(kept[i].string());
    std::cerr << (kept.size() > most_named ? ", ...\n" : "\n");
}

}  // namespace zproof
