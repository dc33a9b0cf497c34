#include "reports/plan.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "frame/frame_error.h"
#include "frame/input_file.h"
#include "math/sha256.h"
#include "reports/report_error.h"
#include "reports/whole_number.h"

namespace zproof {
namespace {

using Json = nlohmann::ordered_json;

/// Half a millisecond more or less moves no unit.
double rounded_to_ms(double seconds) { return std::round(seconds * 1e3) / 1e3; }

Json scene_object(const PlannedScene& scene) {
    Json view_s = Json::array();
    for (const double seconds : scene.view_s) view_s.push_back(rounded_to_ms(seconds));
    return {{"scene", scene.scene},
            {"views", scene.views},
            {"shards", scene.shards},
            {"setup_s", rounded_to_ms(scene.setup_s)},
            {"view_s", view_s}};
}

/// A line for each scene: a plan is read by people, too.
std::string scene_lines(const std::vector<PlannedScene>& scenes) {
    std::string lines;
    for (const PlannedScene& scene : scenes)
        lines += (lines.empty() ? "" : ",\n") + std::string{"    "} +
                 scene_object(scene).dump(-1, ' ', false, Json::error_handler_t::replace);
    return lines;
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string run_text(const PlannedRun& run) {
    return "  {\"name\": " + text_of(run.name) + ",\n   \"argv\": " + text_of(run.argv) +
           ",\n   \"selection\": " +
           text_of({{"scenes", run.selection.scenes},
                    {"sha256", run.selection.sha256},
                    {"passed_over", run.selection.passed_over}}) +
           ",\n   \"scenes\": [\n" + scene_lines(run.scenes) + "\n   ]}";
}

[[noreturn]] void refuse(const std::string& why) { throw ReportError{why}; }

/// Every list has an entry per view, and every shard is one of the plan's.
void require_whole(const PlannedScene& scene, int shards) {
    const std::size_t units = std::max<std::size_t>(1, scene.views.size());
    if (scene.shards.size() != units || scene.view_s.size() != units)
        refuse("scene " + scene.scene + ": expected " + std::to_string(units) + " shards and view_s");
    if (std::ranges::any_of(scene.shards, [&](int shard) { return shard < 1 || shard > shards; }))
        refuse("scene " + scene.scene + ": expected shards from 1 to " + std::to_string(shards));
}

PlannedScene scene_from(const Json& json, int shards) {
    PlannedScene scene{.scene = json.at("scene"),
                       .views = json.at("views"),
                       .shards = {},
                       .setup_s = json.at("setup_s"),
                       .view_s = json.at("view_s")};
    for (const Json& shard : json.at("shards")) scene.shards.push_back(whole_number<int>(shard));
    require_whole(scene, shards);
    return scene;
}

PlannedRun run_from(const Json& json, int shards) {
    const Json& selection = json.at("selection");
    PlannedRun run{
        .name = json.at("name"),
        .argv = json.at("argv"),
        .selection = {whole_number<std::size_t>(selection.at("scenes")), selection.at("sha256"), {}},
        .scenes = {}};
    for (const auto& [ending, files] : selection.at("passed_over").items())
        run.selection.passed_over[ending] = whole_number<std::uint64_t>(files);
    for (const Json& scene : json.at("scenes")) run.scenes.push_back(scene_from(scene, shards));
    if (run.scenes.size() != run.selection.scenes)
        refuse("expected " + std::to_string(run.selection.scenes) + " scenes, found " +
               std::to_string(run.scenes.size()));
    return run;
}

Plan plan_from(const Json& json) {
    if (const int version = whole_number<int>(json.at("zproof_plan")); version != Plan::format_version)
        refuse("its format is " + std::to_string(version) + ", this zproof reads " +
               std::to_string(Plan::format_version) + "; make the plan with this zproof");
    Plan plan{.version = json.at("version"),
              .commit = json.at("commit"),
              .shards = whole_number<int>(json.at("shards")),
              .runs = {}};
    if (plan.shards < 1) refuse("expected shards of at least 1");
    for (const Json& run : json.at("runs")) plan.runs.push_back(run_from(run, plan.shards));
    if (plan.runs.empty()) refuse("expected runs");
    return plan;
}

}  // namespace

std::string to_json(const Plan& plan) {
    std::string runs;
    for (const PlannedRun& run : plan.runs) runs += (runs.empty() ? "" : ",\n") + run_text(run);
    return "{\"zproof_plan\": " + std::to_string(Plan::format_version) +
           ",\n \"version\": " + text_of(plan.version) + ",\n \"commit\": " + text_of(plan.commit) +
           ",\n \"shards\": " + std::to_string(plan.shards) + ",\n \"runs\": [\n" + runs + "\n ]}\n";
}

Plan read_plan(const std::filesystem::path& file) {
    try {
        const std::string text = read_input(file, {"a plan (zproof plan)", largest_result_bytes});
        Plan plan = plan_from(Json::parse(text));
        plan.sha256 = sha256_of(text);
        return plan;
    } catch (const FrameError& e) {
        throw ReportError{e.what()};
    } catch (const Json::exception& e) {
        throw ReportError{file.string() + ": is no plan (zproof plan makes one): " + e.what()};
    } catch (const ReportError& e) {
        throw ReportError{file.string() + ": " + e.what()};
    }
}

}  // namespace zproof
