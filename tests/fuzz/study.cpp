// study.json, and behind a 0 the bytes of every file that it names.
#include "reports/pages/json.h"
#include "tests/fuzz/harness.h"

namespace zproof::fuzz {

void read_input(Input input) {
    const auto files = split_at_zero(input);
    const document::ReadFile read_file = [&](const std::string&) { return text_of(files.second); };
    may_refuse<ReportError>([&] {
        const document::Document study = document::document_from_json(text_of(files.first), read_file);
        const std::string text = json_of(study);
        require(json_of(document::document_from_json(text, read_file)) == text,
                "a written study is read back");
    });
}

}  // namespace zproof::fuzz
