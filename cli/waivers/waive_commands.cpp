// zproof waive list, check, prune.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cli/commands.h"
#include "cli/report_files.h"
#include "cli/waivers/waiver_file.h"
#include "frame/folder_lock.h"
#include "frame/joined.h"
#include "frame/whole_file.h"
#include "program/usage_error.h"
#include "reports/waiver_status.h"
#include "reports/wording.h"

namespace zproof {
namespace {

void require_file(const GateArguments& gate) {
    if (gate.waivers.empty())
        throw UsageError{
            "waive: expected --waivers FILE.toml (or ZPROOF_WAIVERS, or waivers = in zproof.toml)"};
}

/// "expired 3 days ago", "12 days left".
std::string time_left(const Waiver& waiver, Day today) {
    const auto days = (std::chrono::sys_days{waiver.expires} - std::chrono::sys_days{today}).count();
    return days < 0 ? "expired " + counted(std::uint64_t(-days), "day") + " ago"
                    : counted(std::uint64_t(days), "day") + " left";
}

std::string classes_of(const Waiver& waiver) {
    return joined(waiver.classes, ", ", [](PixelClass c) { return name_of(c); });
}

std::string line_of(const Waiver& w, Day today) {
    return w.id + "  " + in_words(w.expires) + " (" + time_left(w, today) + ")  " + w.scene + "/" + w.view +
           "  " + classes_of(w) + "  " + std::to_string(w.least) + " to " + counted(w.most, "pixel") +
           "\n    " + w.reason + "\n    " + w.link + "\n";
}

/// The waivers as they stand on what a run saw; without a run, only their dates are known.
Results results_with_waivers(const Gate& gate, const std::filesystem::path& results) {
    Results seen;
    if (!results.empty()) seen = read_results(results);
    seen.waivers = gate.waivers;
    seen.today = in_words(gate.today);
    seen.strictness = gate.strictness;
    return seen;
}

}  // namespace

ExitCode execute(const WaiveListArguments& arguments) {
    require_file(arguments.gate);
    const Gate gate = open_gate(arguments.gate);
    for (const Waiver& waiver : gate.waivers) std::cout << printable(line_of(waiver, gate.today));
    std::cout << counted(gate.waivers.size(), "waiver") << "\n";
    return ExitCode::proven;
}

ExitCode execute(const WaiveCheckArguments& arguments) {
    require_file(arguments.gate);
    const Gate gate = open_gate(arguments.gate);
    const Results seen = results_with_waivers(gate, arguments.results);
    for (const WaiverStatus& status : waiver_statuses(seen)) {
        const bool is_error = fails(status, gate.strictness);
        const std::string advice = advice_for(status);
        if (!advice.empty() && (is_error || !arguments.common.is_quiet()))
            std::cout << (is_error ? "error: " : "warning: ") << one_line(advice) << "\n";
    }
    std::cout << counted(gate.waivers.size(), "waiver") << ", well formed\n";
    return waivers_fail(seen) ? ExitCode::defect : ExitCode::proven;
}

ExitCode execute(const WaivePruneArguments& arguments) {
    require_file(arguments.gate);
    const std::filesystem::path &file = arguments.gate.waivers, &out = arguments.common.out,
                                &target = out.empty() ? file : out;
    const FolderLock lock(folder_of(target));  // others add and prune before or after
    const Gate gate = open_gate(arguments.gate);
    const Results seen = results_with_waivers(gate, arguments.results);
    std::vector<std::string> ids;
    std::string removed;
    for (const WaiverStatus& status : waiver_statuses(seen)) {
        using enum WaiverStatus::State;
        if (status.state != expired && status.state != unused) continue;
        ids.push_back(status.waiver->id);
        removed +=
            "removed " + one_line(status.waiver->id) + ": " + std::string(name_of(status.state)) + "\n";
    }
    if (!ids.empty() || target != file)
        write_whole_file(target, without_waivers(content_of(file), ids, file.string()));
    std::cout << (arguments.common.is_quiet() ? "" : removed)
              << counted(gate.waivers.size() - ids.size(), "waiver") << " left\n";
    return ExitCode::proven;
}

}  // namespace zproof
