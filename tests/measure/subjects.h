/// Renderers to be measured: the rasterizer by any rules, and the rasterizer behind a distortion.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "measure/measure.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/rasterizer.h"

namespace zproof::measure {

inline Renderer by_rules(const rasterizer::Rules& rules) {
    return {.name = "rules",
            .render = [rules](const Scene& scene,
                              const View& view) { return rasterizer::render_by(rules, scene, view); },
            .declared = rasterizer::precision()};
}

/// The correct rasterizer, with every vertex moved first: place(position, eye).
template <class VertexMap>
Renderer with_moved_vertices(VertexMap place) {
    return {.name = "moved",
            .render =
                [place](Scene scene, const View& view) {
                    for (glm::vec3& p : scene.vertices.position_world) p = place(p, view.camera.eye_world);
                    return rasterizer::render(scene, view);
                },
            .declared = rasterizer::precision()};
}

inline const Finding& finding(const std::vector<Finding>& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, &Finding::name);
    if (found == all.end()) throw std::out_of_range{"no finding " + name};
    return *found;
}

inline std::vector<std::string> worse_in(const std::vector<Finding>& all) {
    std::vector<std::string> names;
    for (const Finding& f : all) {
        if (f.conformity == Conformity::worse) names.push_back(f.name);
    }
    return names;
}

}  // namespace zproof::measure
