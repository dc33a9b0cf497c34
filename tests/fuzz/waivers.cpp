// waivers.toml, and what `zproof waive` writes of it.
#include "cli/waivers/waiver_file.h"
#include "program/usage_error.h"
#include "tests/fuzz/harness.h"

namespace zproof::fuzz {

void read_input(Input input) {
    const std::string text = text_of(input);
    std::vector<Waiver> waivers;
    may_refuse<UsageError>([&] { waivers = parse_waivers(text, "input.toml"); });
    if (waivers.empty()) return;
    std::string written = empty_waiver_file();
    for (const Waiver& waiver : waivers) written += waiver_text(waiver);
    const std::vector<Waiver> again = parse_waivers(written, "again.toml");
    require(again.size() == waivers.size(), "as many waivers as were written are read back");
    for (std::size_t i = 0; i < again.size(); ++i)
        require(waiver_text(again[i]) == waiver_text(waivers[i]), "a written waiver is read back");
    may_refuse<UsageError>([&] {
        const std::string rest = without_waivers(text, {waivers.front().id}, "input.toml");
        require(parse_waivers(rest, "rest.toml").size() == waivers.size() - 1, "one waiver is taken out");
    });
}

}  // namespace zproof::fuzz
