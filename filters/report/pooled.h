/// All textures of a study together, as a table and as a plot.
#pragma once

#include "filters/report/plots.h"
#include "filters/report/table_cells.h"
#include "filters/study/statistics.h"

namespace zproof {

/// Rank, method, mean with its 95 % interval, the interval of ranks, how often it is the best, and what it
/// has more than the baseline.
TableCells pooled_cells(const study::StudyResults& results, const study::PooledScores& pool);

/// A sentence for what is left out of the pool, methods and textures; none where nothing is.
std::vector<std::string> left_out_in_words(const study::PooledScores& pool);

/// Every metric of a region, a row for each method, as the numbers are: pooled.csv. RFC 4180 with LF.
std::string pooled_csv(const study::StudyResults& results, const std::string& region);

/// The pools that a page shows, the interior by PSNR and by FLIP.
std::vector<study::PooledScores> page_pools(const study::StudyResults& results);

/// The means with their intervals, the best first.
Plot pooled_plot(const study::StudyResults& results, const study::PooledScores& pool);

}  // namespace zproof
