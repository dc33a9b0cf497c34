/// Where a study's files come from, as names and values.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "filters/study/results.h"

namespace zproof {

/// Version, commit, command, compiler, processor, date and truth of the study; of a view also its scene, its
/// name and the SHA-256 of its scene.
std::vector<std::pair<std::string, std::string>> provenance_of(const study::StudyResults& results);
std::vector<std::pair<std::string, std::string>> provenance_of(const study::StudyResults& results,
                                                               const study::ViewStudy& view);

/// Lines that begin with "# ", as CSV readers skip them when asked to (pandas: comment="#"; R: comment.char).
std::string provenance_comment(const study::StudyResults& results);

}  // namespace zproof
