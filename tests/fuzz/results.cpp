// results.json, and every report without pictures that is made of it.
#include "reports/formats.h"
#include "reports/json.h"
#include "reports/terminal.h"
#include "tests/fuzz/harness.h"

namespace zproof::fuzz {

void read_input(Input input) {
    Results results;
    may_refuse<ReportError>([&] { results = results_from_json(text_of(input)); });
    const std::string text = to_json(results);
    require(to_json(results_from_json(text)) == text, "a written results.json is read back");
    to_junit(results);
    to_github(results);
    to_csv(results);
    summary_table(results, {.colour = Colour::ansi});
    require(to_markdown(results).size() <= largest_summary, "a summary is as small as GitHub takes it");
}

}  // namespace zproof::fuzz
