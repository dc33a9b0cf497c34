// The verdict on each view of the suite beside the reference's rays for it, at 1920 x 1080.
#include "compare/judge.h"

#include "bench/lazy.h"
#include "bench/suites.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof::bench {
namespace {

/// One scene at a time: the next one takes its place.
struct CurrentScene {
    std::string name;
    std::optional<Loaded> loaded;
    std::optional<oracle::Embree> embree;

    /// Is it set anew?
    bool set(const std::string& scene) {
        if (name == scene) return false;
        embree.reset();
        loaded = generate_suite_scene(scene, 1920, 1080);
        embree.emplace(loaded->scene);
        name = scene;
        return true;
    }
};

void add_view(const std::shared_ptr<CurrentScene>& current_scene, const std::string& scene, std::size_t index,
              const std::string& view_name) {
    const std::string name = "judge/" + scene + "-" + view_name;
    const auto set = [=] {
        return [=, is_new = new_once()] { return current_scene->set(scene) | is_new(); };
    };
    const auto rays = [=] {
        benchmark::DoNotOptimize(current_scene->embree->trace(current_scene->loaded->views[index]));
    };
    add(name + "/Embree's rays", rays, {}, set());
    struct Frames {
        Frame candidate, reference;
    };
    const Lazy<Frames> frames{[=] {
        const View& view = current_scene->loaded->views[index];
        return Frames{rasterizer::render(current_scene->loaded->scene, view),
                      current_scene->embree->trace(view)};
    }};
    const auto judged = [=](const JudgeOptions& options) {
        return [=] {
            const auto& [candidate, reference] = *frames;
            const View& view = current_scene->loaded->views[index];
            benchmark::DoNotOptimize(judge(current_scene->loaded->scene, view,
                                           RenderedFrame{candidate, rasterizer::precision()},
                                           RenderedFrame{reference, oracle::embree_precision()}, options));
        };
    };
    add(name + "/zproof", judged({}), {}, set());
    add(name + "/all evidence", judged(full_detail), {}, set());
}

}  // namespace

void add_judge() {
    const auto current_scene = std::make_shared<CurrentScene>();
    for (const SuiteEntry& entry : suite_manifest()) {
        const Loaded small = generate_suite_scene(entry.name, 16, 9);
        for (std::size_t i = 0; i < small.views.size(); ++i)
            add_view(current_scene, entry.name, i, small.views[i].name);
    }
}

}  // namespace zproof::bench
