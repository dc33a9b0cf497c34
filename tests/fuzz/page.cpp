// report.html of a results.json, and behind a 0 the planes.zvp of its views.
#include "reports/html.h"
#include "reports/json.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto files = split_at_zero(input);
    std::filesystem::create_directories(folder.path() / "view");
    folder.write("view/planes.zvp", files.second);
    may_refuse<ReportError>([&] {
        Results results = results_from_json(text_of(files.first));
        for (ViewResult& view : results.views) view.folder = "view";
        to_html(results, folder.path());
    });
}

}  // namespace zproof::fuzz
