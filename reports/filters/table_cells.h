/// What stands in a table of a study, whoever sets it.
#pragma once

#include <string>
#include <vector>

#include "study/filters/results.h"

namespace zproof {

struct TableColumn {
    std::string name;
    bool is_text = false;           ///< set to the left
    bool higher_is_better = false;  ///< of a number
};

struct TableCells {
    std::string title;
    std::vector<TableColumn> columns;
    std::vector<std::vector<std::string>> rows;
};

inline constexpr std::string_view not_resolved = "not resolved";

/// One view, one region: rank, method, metrics, flicker, costs.
TableCells table_cells(const study::StudyResults& results, const study::ViewStudy& view,
                       const std::string& region);

/// "GT-N: mean over the pixel's square of the nearest-reconstructed texture".
std::string truth_in_words(const std::string& truth);

/// "12.3 KiB".
std::string bytes_in_words(std::uint64_t bytes);

}  // namespace zproof
