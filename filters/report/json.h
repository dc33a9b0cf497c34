/// A study of texture filters as filters.json, and back.
#pragma once

#include <string>

#include "filters/study/results.h"
#include "reports/report_error.h"

namespace zproof {

/// Everything, in the results' own order; what is not finite stands as "nan", "inf" or "-inf". A region
/// without pixels has no values.
std::string filters_json(const study::StudyResults& results);

/// Throws ReportError where the text is not what filters_json of the same major version writes.
study::StudyResults filters_from_json(const std::string& text);

}  // namespace zproof
