/// What stands in a table of a study, whoever sets it.
#pragma once

#include <string>
#include <vector>

#include "filters/study/results.h"

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

/// What a reader wants of a table.
struct TableChoice {
    std::string region = "interior";
    std::vector<std::string> columns{};  ///< beside rank and method, in this order; empty: all
    std::string sort{};                  ///< a column, the best first; empty: methods as the study has them
};

/// The names of all columns beside rank and method: metrics, flicker, costs.
std::vector<std::string> column_names(const study::StudyResults& results);

/// One view, one region: rank, method, metrics, flicker, costs. Names must be columns.
TableCells table_cells(const study::StudyResults& results, const study::ViewStudy& view,
                       const TableChoice& choice);

/// "GT-N: mean over the pixel's square of the nearest-reconstructed texture".
std::string truth_in_words(const std::string& truth);

/// "12.3 KiB".
std::string bytes_in_words(std::uint64_t bytes);

}  // namespace zproof
