#include "compare/diagnosis/hypotheses/radial_distortion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zproof {

namespace {

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
        const Neighbourhood around = wide_.around({int(in_wide.x), int(in_wide.y), {}}, 1);
        const PrimitiveId said = claim.answer.primitive;
        if (around.neighbours.empty() && said == PrimitiveId::none) return ReportedDepth{};
        const auto near = std::make_shared<Scene>();
        for (const Neighbour& n : around.neighbours) {
            const auto first = std::uint32_t(near->vertices.position_world.size());
            for (const glm::vec3& p : n.p_world) near->vertices.position_world.push_back(p);
            near->triangles.push_back({first, first + 1, first + 2});
        }
        OtherWorld world(input_, near,
                         shifted_view(input_.view, sampled_at(input_.view, claim.x, claim.y) - at));
        Claim reading = claim;
        if (said == PrimitiveId::none && world.admits(reading)) return ReportedDepth{};
        for (std::size_t i = 0; i < around.neighbours.size(); ++i) {
            if (!may_stand_for(PrimitiveId(around.neighbours[i].triangle), said)) continue;
            reading.answer.primitive = PrimitiveId(i);
            if (world.admits(reading)) return world.depth_of(reading);
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
    const double r = length(pixel);
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
