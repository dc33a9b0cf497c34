#include "cli/plan/expected_seconds.h"

#include <algorithm>
#include <map>

#include "program/samples.h"

namespace zproof {
namespace {

/// Reading, baking, and the tree of the ray caster. Seconds; docs/scale.md says where the constants are from.
double model_of_setup(std::uint64_t triangles) { return 1.2e-3 + 6.1e-7 * double(triangles); }

/// Both pictures, and the judge.
double model_of_view(std::uint64_t triangles, double pixels) {
    return 3.5e-3 + 3.4e-8 * pixels + 7.0e-8 * double(triangles);
}

double setup_of(const StageTimes& times) { return times.load + times.reference_build; }

/// In the order of its views. The set-up is in the times of the first view that a process judged.
PlannedScene planned(std::vector<const ViewResult*> views) {
    std::ranges::sort(views, {}, &ViewResult::view_place);
    PlannedScene scene{.scene = views.front()->scene, .views = {}, .shards = {}, .view_s = {}};
    for (const ViewResult* view : views) {
        scene.views.push_back(view->view);
        scene.setup_s = std::max(scene.setup_s, setup_of(view->times));
        scene.view_s.push_back(seconds(view->times) - setup_of(view->times));
    }
    return scene;
}

bool are_all_there(const std::vector<const ViewResult*>& views) {
    return views.size() == views.front()->scene_views &&
           std::ranges::all_of(views, [](const ViewResult* v) { return was_judged(*v); });
}

double model_of(const std::vector<const ViewResult*>& views) {
    double all = model_of_setup(views.front()->triangles);
    for (const ViewResult* v : views) all += model_of_view(v->triangles, double(v->width) * v->height);
    return all;
}

double sum_of(const PlannedScene& scene) {
    double all = scene.setup_s;
    for (const double seconds : scene.view_s) all += seconds;
    return all;
}

}  // namespace

EarlierRun::EarlierRun(const Results& results) {
    std::map<std::string, std::vector<const ViewResult*>> by_scene;
    for (const ViewResult& view : results.views) by_scene[view.scene].push_back(&view);
    double measured_s = 0, model_s = 0;
    for (const auto& [name, views] : by_scene) {
        if (!are_all_there(views)) continue;
        const PlannedScene& scene = scenes_.emplace(name, planned(views)).first->second;
        measured_s += sum_of(scene);
        model_s += model_of(views);
    }
    if (model_s > 0) slowness_ = measured_s / model_s;
}

std::optional<PlannedScene> EarlierRun::scene(const std::string& name) const {
    const auto found = scenes_.find(name);
    if (found == scenes_.end()) return std::nullopt;
    return found->second;
}

PlannedScene expected_of(const std::string& name, const Scene& scene, const std::vector<View>& views,
                         double slowness) {
    PlannedScene expected{.scene = name,
                          .views = {},
                          .shards = {},
                          .setup_s = slowness * model_of_setup(scene.triangles.size()),
                          .view_s = {}};
    for (const View& view : views) {
        expected.views.push_back(shown_name(view));
        expected.view_s.push_back(slowness *
                                  model_of_view(scene.triangles.size(), double(view.width) * view.height));
    }
    return expected;
}

PlannedScene expected_of_none(const std::string& name, double slowness) {
    return {.scene = name, .views = {}, .shards = {}, .setup_s = 0, .view_s = {slowness * model_of_setup(0)}};
}

}  // namespace zproof
