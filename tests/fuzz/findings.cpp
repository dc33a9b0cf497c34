// findings.csv.
#include "reports/findings_file.h"
#include "reports/report_error.h"
#include "tests/fuzz/harness.h"

namespace zproof::fuzz {

void read_input(Input input) {
    may_refuse<ReportError>([&] { findings_from_csv(text_of(input), "input.csv"); });
}

}  // namespace zproof::fuzz
