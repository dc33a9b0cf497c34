#include "cli/plan/missing_shards.h"
#include "program/shell_line.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace zproof {
namespace {

/// The folder of another shard, named as the example is: "shards/3" where that is "shards/1".
std::filesystem::path folder_like(const std::filesystem::path& example, int number) {
    std::string name = example.string();
    while (name.size() > 1 && name.back() == '/') name.pop_back();
    while (!name.empty() && std::isdigit(std::uint8_t(name.back())) != 0) name.pop_back();
    return name + std::to_string(number);
}

}  // namespace

std::string MissingShards::fault_of(const Results& results) const {
    const Shard& shard = results.shard;
    const std::string which = "shard " + std::to_string(shard.number);
    if (shard.plan != planned_.plan.sha256) return which + " in '" + results.command + "' is of another plan";
    if (shard.count != planned_.plan.shards || shard.number > shard.count)
        return which + " is not of the plan";
    if (results.ending == Ending::interrupted || results.ending == Ending::stopped)
        return which + " was " + std::string(name_of(results.ending));
    return "";
}

std::size_t MissingShards::count() const { return std::size_t(std::ranges::count(is_there_, false)); }

std::vector<std::string> MissingShards::commands(const std::filesystem::path& plan,
                                                 const std::filesystem::path& example) const {
    std::vector<std::string> lines;
    for (int number = 1; number <= planned_.plan.shards; ++number)
        if (!is_there(number))
            lines.push_back("shard " + std::to_string(number) + " is missing; to make it: " +
                            shard_command(plan, number, folder_like(example, number)));
    return lines;
}

std::vector<ViewResult> MissingShards::views() const {
    std::vector<ViewResult> views;
    for (std::size_t place = 0; place < planned_.run.scenes.size(); ++place) {
        const PlannedScene& scene = planned_.run.scenes[place];
        for (std::size_t i = 0; i < scene.shards.size(); ++i) {
            if (is_there(scene.shards[i])) continue;
            ViewResult& view = views.emplace_back();
            view.scene = scene.scene;
            view.view = scene.views.empty() ? "" : scene.views[i];
            view.place = place;
            view.view_place = i;
            view.scene_views = scene.views.size();
            view.outcome = Outcome::not_judged;
            view.message = "shard " + std::to_string(scene.shards[i]) + " is missing";
        }
    }
    return views;
}

std::string shard_command(const std::filesystem::path& plan, int number,
                          const std::filesystem::path& folder) {
    return shell_line({"run", "--plan", plan.string(), "--shard", std::to_string(number), "--exit-zero",
                       "--report", "json", "-o", folder.string()});
}

std::filesystem::path folder_of(const PlannedRun& run, const std::filesystem::path& folder) {
    return run.name.empty() ? folder : folder / run.name;
}

ReportArguments report_of(const PlannedRun& run, const ReportArguments& report) {
    ReportArguments of_run = report;
    of_run.common.out = folder_of(run, report.common.out);
    return of_run;
}

}  // namespace zproof
