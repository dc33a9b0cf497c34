/// results.json: everything that a run found out, for programs. Its shape is reports/results.schema.json.
#pragma once

#include <string>
#include <vector>

#include "reports/report_error.h"
#include "reports/results.h"
#include "reports/text_sink.h"

namespace zproof {

/// The whole run as JSON text, UTF-8, ending in a newline, view by view. Numbers read back to the same bits;
/// what JSON has no number for is written as "nan", "inf" or "-inf"; float32 depths come with their bits in
/// hexadecimal beside them. What may differ between two runs of the same input stands in `run` and in each
/// view's `times`, nowhere else.
void write_json(const TextSink& out, const Results& results);
std::string to_json(const Results& results);  ///< the same, in memory
std::string waivers_as_json(const std::vector<Waiver>& waivers);

/// Inverse of to_json(). Keys that it does not know are passed over. Throws ReportError naming the place
/// where a key is missing or of another type, and where the schema's major version is not ours.
Results results_from_json(const std::string& text);

/// The results as MessagePack, for another process of this program: text keeps bytes that are no UTF-8, which
/// to_json() replaces.
std::string to_message_pack(const Results& results);
Results results_from_message_pack(const std::string& bytes);

}  // namespace zproof
