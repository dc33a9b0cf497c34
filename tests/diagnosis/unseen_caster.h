/// A ray caster in float64 with defects that were listed, and given their true names, before the diagnosis
/// was asked about any of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::test {

/// Where a view ray meets a triangle.
struct CasterHit {
    double camera_depth;
    std::uint32_t id;
    double u, v;  ///< weights of the second and third corner
};

/// What is wrong with the caster; every part is right unless it says otherwise.
struct CasterDefect {
    std::string name;
    std::vector<std::string> true_names;  ///< how its cause begins; empty: no hypothesis describes it
    std::function<void(View&)> camera{};  ///< what it takes for the view
    std::function<glm::dvec2(const View&, int x, int y)> p_raster{};  ///< where it samples a pixel
    std::function<bool(const Scene&, std::uint32_t id)> draws{};
    double least_weight = 0, least_u = 0;  ///< a hit has no smaller weight
    std::function<const CasterHit*(const std::vector<CasterHit>&)>
        shown{};                                                     ///< of all hits, by id; else the nearest
    std::function<void(const Scene&, const View&, Frame&)> after{};  ///< what becomes of the frame
};

const std::vector<CasterDefect>& caster_defects();

Frame cast(const Scene& scene, const View& view, const CasterDefect& defect);

}  // namespace zproof::test
