#include "program/publish.h"

#include <algorithm>
#include <iostream>

#include "reports/wording.h"

namespace zproof {

namespace {

void say_kept(const std::vector<std::filesystem::path>& kept) {
    constexpr std::size_t most_named = 3;
    if (kept.empty()) return;
    std::cerr << "zproof: kept " << counted(kept.size(), "file") << " that zproof did not write:";
    for (std::size_t i = 0; i < std::min(kept.size(), most_named); ++i)
        std::cerr << (i == 0 ? " " : ", ") << one_line(kept[i].string());
    std::cerr << (kept.size() > most_named ? ", ...\n" : "\n");
}

}  // namespace

std::filesystem::path publish(OutputFolder& folder, const CommonArguments& common,
                              Completeness completeness) {
    const std::filesystem::path& typed = common.out;
    const std::vector<std::filesystem::path> kept = folder.publish(completeness);
    if (!common.is_quiet()) say_kept(kept);
    if (folder.suffix().empty()) return typed;
    const std::filesystem::path full = typed.has_filename() ? typed : typed.parent_path();
    const std::filesystem::path partial = full.string() + folder.suffix();
    if (!common.is_quiet())
        std::cerr << "zproof: " << one_line(full.string()) << " keeps the last full report; this one is in "
                  << one_line(partial.string()) << "\n";
    return partial;
}

}  // namespace zproof
