// plan.json: what zproof plan writes and its shards read.
#include "reports/plan.h"
#include "reports/report_error.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto file = folder.write("plan.json", input);
    may_refuse<ReportError>([&] {
        const std::string text = to_json(read_plan(file));
        const auto written = folder.write("written.json", text);
        require(to_json(read_plan(written)) == text, "a written plan is read back");
    });
}

}  // namespace zproof::fuzz
