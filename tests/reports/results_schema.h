/// The JSON schema of results.json, as the rows of reports/result_fields.h give it.
#pragma once

#include <string>

namespace zproof {

/// The text of reports/results.schema.json.
std::string results_schema();

}  // namespace zproof
