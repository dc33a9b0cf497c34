#include "compare/diagnosis/hypotheses/radial_distortion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/admissible/admissibility.h"
#include "compare/admissible/depth_rule.h"

namespace zproof {

namespace {

/// How far triangles are looked for around a ray, px.
constexpr double bent_reach_px = 1;

/// Decides each claim in the view whose pixel looks along the claim's bent ray.
class BentView {
  public:
    BentView(const DiagnosisInput& input, const RadialDistortion& lens)
        : input_(input), lens_(lens), wide_(input, declared_scene(input), wide_view(input.view)) {}

    /// The depths that the claim may have there; nothing where it is not admissible.
    std::optional<ReportedDepth> admitted(const Claim& claim) {
        const glm::dvec2 at = seen_from(claim);
        const glm::dvec2 size(input_.view.width, input_.view.height), in_wide = at + size;
        if (any(lessThan(in_wide, glm::dvec2(0))) || any(greaterThanEqual(in_wide, 3.0 * size)))
            return std::nullopt;
        SearchPixel pixel{claim.x, claim.y, bent_reach_px, {}};
        const Claim there{int(in_wide.x), int(in_wide.y), {}};
        for (const Neighbour& n : wide_.around(there, bent_reach_px).neighbours)
            pixel.triangles.push_back(n.triangle);
        const View bent = shifted_view(input_.view, sampled_at(input_.view, claim.x, claim.y) - at);
        const PrimitiveId said = claim.answer.primitive;
        if (said == PrimitiveId::none && is_seen(bent, pixel, claim)) return ReportedDepth{};
        for (const std::uint32_t triangle : pixel.triangles) {
            if (!may_stand_for(PrimitiveId(triangle), said)) continue;
            const Claim reading{claim.x, claim.y, {PrimitiveId(triangle), claim.answer.camera_depth}};
            if (const auto depths = depths_of(bent, reading); depths && is_seen(bent, pixel, reading))
                return depths;
        }
        return std::nullopt;
    }

  private:
    /// Three times as wide and high, with as many more pixels: rays are bent beyond the picture.
    static View wide_view(View view) {
        Window& w = view.camera.window;
        const double width = w.right - w.left, height = w.top - w.bottom;
        w = {w.left - width, w.right + width, w.bottom - height, w.top + height};
        view.width *= 3;
        view.height *= 3;
        return view;
    }

    /// May the view show the claim's triangle, or background, at the pixel that it is asked for?
    bool is_seen(const View& view, const SearchPixel& pixel, const Claim& claim) const {
        const ViewBounds bounds(view, input_.candidate.precision);
        const PrimitiveId id = claim.answer.primitive;
        if (id == PrimitiveId::none && claim.answer.camera_depth != background_depth) return false;
        const double eps_px = own_eps_px(input_.scene, view, bounds, {claim.x, claim.y}, id);
        if (eps_px > bent_reach_px) return false;
        const Neighbourhood around = neighbourhood_of(input_.scene, view, bounds, pixel, eps_px);
        return around.eps_px <= bent_reach_px && is_admissible(decide(around, id).admissibility);
    }

    /// The depths that the claimed triangle may have in that view, if its depth is one.
    std::optional<ReportedDepth> depths_of(const View& view, const Claim& claim) const {
        const ViewBounds shown = ViewBounds::of_shown(view, input_.candidate.precision);
        const CornersWorld p_world = corners_of(input_.scene, std::uint32_t(claim.answer.primitive));
        const TriangleDepth triangle(TriangleInView(view, shown, p_world), shown);
        if (!check_depth(view, shown, p_world, triangle, {claim.x, claim.y}, claim.answer.camera_depth)
                 .is_admissible)
            return std::nullopt;
        const DepthBound bound = triangle.at(claim.x, claim.y);
        return ReportedDepth{bound.low, bound.high};
    }

    bool may_stand_for(PrimitiveId triangle, PrimitiveId said) const {
        return input_.said ? have_one_label(input_.said->labels, triangle, said) : triangle == said;
    }

    /// The raster position in the declared view of what the claim's pixel shows.
    glm::dvec2 seen_from(const Claim& claim) const {
        const Window& w = input_.view.camera.window;
        const glm::dvec2 corner(w.left, w.top),
            per_px((w.right - w.left) / input_.view.width, (w.bottom - w.top) / input_.view.height);
        return (lens_.ray_of(corner + per_px * sampled_at(input_.view, claim.x, claim.y)) - corner) / per_px;
    }

    const DiagnosisInput& input_;
    RadialDistortion lens_;
    OtherWorld wide_;
};

}  // namespace

glm::dvec2 RadialDistortion::ray_of(const glm::dvec2& pixel) const {
    constexpr int steps = 30;
    const double r = length(pixel / unit);
    if (distorted == Distorted::pixel || r == 0) return pixel * (1 + k1 * r * r);
    const double farthest = k1 < 0 ? 1 / std::sqrt(-3 * k1) : r;  // no ray meets a pixel beyond its image
    double ray = std::min(r, farthest);
    for (int i = 0; i < steps && 1 + 3 * k1 * ray * ray > 0; ++i)  // Newton's method
        ray = std::min(farthest, ray - (ray * (1 + k1 * ray * ray) - r) / (1 + 3 * k1 * ray * ray));
    return pixel * (ray / r);
}

Hypothesis shown_through(const DiagnosisInput& input, Cause cause, const RadialDistortion& lens) {
    const auto view = std::make_shared<BentView>(input, lens);
    return decided(input, std::move(cause), [view](const Claim& claim) { return view->admitted(claim); });
}

}  // namespace zproof
