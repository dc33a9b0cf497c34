#include "filters/reference/admissible_surfaces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <optional>

#include "filters/area/row_spans.h"
#include "filters/area/surfaces.h"
#include "filters/reference/coverage.h"
#include "math/rational.h"

namespace zproof::oracle {

namespace {

using filter_reference::Coverage;
using filter_reference::CoveringTriangle;
using filter_reference::SampleBox;

constexpr double farthest_px = 1;  ///< beyond the displacement

/// A triangle that may cover the sample.
struct Candidate {
    std::uint32_t id;
    const CoveringTriangle* triangle;
    Coverage coverage;
};
using Candidates = std::vector<Candidate>;

/// The triangles of a row of pixels, each made once.
class TrianglesOfRow {
  public:
    TrianglesOfRow(const Scene& scene, const View& view, const FilterPrecision& precision)
        : scene_(scene), view_(view), precision_(precision) {}

    const CoveringTriangle& at(std::uint32_t id) {
        const auto known = made_.find(id);
        if (known != made_.end()) return known->second;
        const glm::uvec3 t = scene_.triangles[id];
        const auto& p = scene_.vertices.position_world;
        return made_.try_emplace(id, view_, std::array{p[t[0]], p[t[1]], p[t[2]]}, precision_).first->second;
    }

  private:
    const Scene& scene_;
    const View& view_;
    const FilterPrecision& precision_;
    std::map<std::uint32_t, CoveringTriangle> made_;
};

/// May the sample leave it, with no triangle of the set to go on with?
bool may_be_left(const Candidate& candidate, const Candidates& set, const SampleBox& box) {
    const auto goes_on = [&](std::size_t edge, const Candidate& other) {
        for (std::size_t i = 0; i < CoveringTriangle::edge_count; ++i)
            if (candidate.triangle->continues_at(edge, *other.triangle, i)) return true;
        return false;
    };
    for (std::size_t bound = 0; bound < CoveringTriangle::bound_count; ++bound) {
        if (!candidate.triangle->is_undecided(bound, box)) continue;
        if (bound >= CoveringTriangle::edge_count) return true;
        if (std::ranges::none_of(set, [&](const Candidate& other) { return goes_on(bound, other); }))
            return true;
    }
    return false;
}

/// Do they cover the sample wherever it is displaced to? One alone, or triangles that share every edge beyond
/// which the sample may lie.
bool certainly_cover(Candidates set, const SampleBox& box) {
    if (std::ranges::any_of(set, [](const Candidate& c) { return c.coverage == Coverage::certain; }))
        return true;
    for (std::size_t before = 0; before != set.size();) {
        before = set.size();
        const Candidates all = set;
        std::erase_if(set, [&](const Candidate& c) { return may_be_left(c, all, box); });
    }
    return !set.empty();
}

Candidates nearer_than(const Candidate& subject, const Candidates& all, const SampleBox& box) {
    Candidates nearer;
    std::ranges::copy_if(all, std::back_inserter(nearer), [&](const Candidate& other) {
        return other.triangle->is_certainly_nearer_than(*subject.triangle, box);
    });
    return nearer;
}

/// Takes out what the nearest certain one hides: among many triangles, nearly all.
void drop_behind_the_nearest(Candidates& all, const SampleBox& box) {
    const CoveringTriangle* nearest = nullptr;
    for (const Candidate& c : all)
        if (c.coverage == Coverage::certain &&
            (nearest == nullptr || c.triangle->is_certainly_nearer_than(*nearest, box)))
            nearest = c.triangle;
    if (nearest == nullptr) return;
    std::erase_if(all,
                  [&](const Candidate& c) { return nearest->is_certainly_nearer_than(*c.triangle, box); });
}

Candidates covering(std::span<const std::uint32_t> ids, TrianglesOfRow& triangles, const SampleBox& box) {
    Candidates found;
    for (const std::uint32_t id : ids) {
        const CoveringTriangle& triangle = triangles.at(id);
        const Coverage coverage = triangle.coverage(box);
        if (coverage != Coverage::none) found.push_back({id, &triangle, coverage});
    }
    return found;
}

/// Appends what may be seen.
void add_admissible(Candidates all, const SampleBox& box, std::vector<PrimitiveId>& ids) {
    drop_behind_the_nearest(all, box);
    for (const Candidate& c : all)
        if (!certainly_cover(nearer_than(c, all, box), box)) ids.push_back(PrimitiveId{c.id});
    if (!certainly_cover(all, box)) ids.push_back(PrimitiveId::none);
}

/// A triangle at one place, in rationals.
struct ExactHit {
    PrimitiveId id = PrimitiveId::none;
    Rational inverse_depth = 0;
};

std::optional<Rational> exact_inverse_depth(const Scene& scene, const View& view, PrimitiveId id, int x,
                                            int y) {
    const glm::uvec3 corners = scene.triangles[std::uint32_t(id)];
    const auto seen =
        area::seen(area::RasterRays<Rational>{view}, area::corners_world<Rational>(scene, corners),
                   area::CornerTexels<Rational>{});
    if (!seen) return std::nullopt;
    const Rational px{x + 0.5}, py{y + 0.5};
    for (const Affine<Rational>& edge : seen->edge)
        if (sign(edge.at(px, py)) < 0) return std::nullopt;
    return seen->inverse_depth.at(px, py);
}

bool is_between_near_and_far(const Camera& camera, const Rational& inverse_depth) {
    if (camera.projection == Projection::parallel)
        return -inverse_depth >= Rational{camera.near_depth} && -inverse_depth <= Rational{camera.far_depth};
    return inverse_depth * Rational{camera.near_depth} <= 1 &&
           (std::isinf(camera.far_depth) ? sign(inverse_depth) > 0
                                         : inverse_depth * Rational{camera.far_depth} >= 1);
}

PrimitiveId exactly_seen(const Scene& scene, const View& view, std::span<const PrimitiveId> admissible, int x,
                         int y) {
    ExactHit nearest;
    for (const PrimitiveId id : admissible) {
        if (id == PrimitiveId::none) continue;
        const auto inverse_depth = exact_inverse_depth(scene, view, id, x, y);
        if (!inverse_depth || !is_between_near_and_far(view.camera, *inverse_depth)) continue;
        if (nearest.id == PrimitiveId::none || *inverse_depth > nearest.inverse_depth)
            nearest = {id, *inverse_depth};
    }
    return nearest.id;
}

float depth_of(const area::Surfaces& surfaces, const View& view, PrimitiveId id, int x, int y) {
    const double inverse_depth = surfaces.seen(std::uint32_t(id))->inverse_depth.at(x + 0.5, y + 0.5);
    return float(view.camera.projection == Projection::parallel ? -inverse_depth : 1 / inverse_depth);
}

}  // namespace

AdmissibleSurfaces::AdmissibleSurfaces(const Scene& scene, const View& view, const FilterPrecision& precision)
    : rows_(std::size_t(view.height)) {
    const area::Surfaces surfaces{scene, view};
    const area::RowSpans spans{
        surfaces, {.size = {view.width, view.height}, .half_side = precision.displacement_px + farthest_px}};
    tbb::parallel_for(0, view.height, [&](int y) {
        TrianglesOfRow triangles{scene, view, precision};
        area::RowSweep sweep{spans.row(y)};
        Row& row = rows_[std::size_t(y)];
        for (int x = 0; x < view.width; ++x) {
            const SampleBox box = filter_reference::sample_box(x, y, precision.displacement_px);
            add_admissible(covering(sweep.at(x), triangles, box), box, row.ids);
            row.first.push_back(row.ids.size());
        }
    });
}

Frame exact_visibility(const Scene& scene, const View& view) {
    const area::Surfaces surfaces{scene, view};
    const AdmissibleSurfaces admissible{scene, view, {.arithmetic_bits = FilterPrecision::exact}};
    Frame frame{{view.width, view.height}};
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            const auto ids = admissible.at(x, y);
            const PrimitiveId id = ids.size() == 1 ? ids[0] : exactly_seen(scene, view, ids, x, y);
            frame.primitive.at(x, y) = id;
            if (id != PrimitiveId::none) frame.camera_depth.at(x, y) = depth_of(surfaces, view, id, x, y);
        }
    });
    return frame;
}

}  // namespace zproof::oracle
