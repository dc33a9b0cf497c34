#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <unordered_set>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/plane_depth.h"
#include "frame/joined.h"
#include "frame/number_text.h"
#include "math/interval.h"
#include "math/rational.h"

namespace zproof {

namespace {

Hypothesis with_rule(const DiagnosisInput& input, const Cause& cause, RuleOverride amend) {
    Hypothesis h = as_declared(input, cause);
    h.amend = std::move(amend);
    return h;
}

/// Who hides whom goes by range(neighbour), [least, greatest], instead of inverse depth; the greater hides.
template <class Range>
RuleOverride ordered_by(Range range) {
    return [range](Neighbourhood& around, PrimitiveId) {
        for (Neighbour& n : around.neighbours) {
            const auto [least, greatest] = range(n);
            n.least_inverse_depth = least;
            n.greatest_inverse_depth = greatest;
            n.gradient = 0;
        }
    };
}

using Range = std::pair<double, double>;

std::vector<Hypothesis> of_the_depth_test(const DiagnosisInput& input) {
    const char* is_on = "Look at whether depth test and depth writes are on, and the buffer attached.";
    Hypothesis reversed = with_rule(input,
                                    {"the depth test is reversed", "The farthest triangle is seen.",
                                     "Look at the depth test's comparison and at the clear value."},
                                    ordered_by([](const Neighbour& n) {
                                        return Range{-n.greatest_inverse_depth, -n.least_inverse_depth};
                                    }));
    reversed.only_permits = true;  // ranges of whole triangles overlap
    return {reversed,
            with_rule(input,
                      {"the depth test is missing: the last drawn wins",
                       "The triangle with the greatest index is seen, at whatever depth.", is_on},
                      ordered_by([](const Neighbour& n) {
                          return Range{n.triangle, n.triangle};
                      })),
            with_rule(input,
                      {"the depth test is missing: the first drawn wins",
                       "The triangle with the least index is seen, at whatever depth.", is_on},
                      ordered_by([](const Neighbour& n) {
                          return Range{-double(n.triangle), -double(n.triangle)};
                      }))};
}

/// The most by which an earlier triangle that hides a later one lies behind it; 0: none does.
double largest_lead(const DiagnosisInput& input) {
    const Frame &ours = input.candidate.frame, &theirs = input.reference.frame;
    const auto told = ours.primitive.pixels(), seen = theirs.primitive.pixels();
    double most = 0;
    for (std::size_t i = 0; i < told.size(); ++i) {
        const double lead = double(ours.camera_depth.pixels()[i]) - double(theirs.camera_depth.pixels()[i]);
        if (told[i] < seen[i] && seen[i] != PrimitiveId::none && std::isfinite(lead))
            most = std::max(most, lead);
    }
    return most;
}

/// What is drawn later must lie nearer by the bias. Each triangle's range is shifted against the answer's.
std::vector<Hypothesis> biased_test(const DiagnosisInput& input) {
    const double bias = largest_lead(input);
    if (bias <= 0) return {};
    Hypothesis h =
        with_rule(input,
                  {"a later triangle hides an earlier one only by a bias",
                   "It must lie nearer by about " + with_digits(bias, 4) + ".",
                   "Look at depth bias and polygon offset, and at a comparison that adds an epsilon."},
                  [bias](Neighbourhood& around, PrimitiveId answer) {
                      const Projection projection = around.view.camera.projection;
                      const auto inverse = [&](double depth) {
                          if (projection == Projection::parallel) return -depth;
                          return depth > 0 ? 1 / depth : std::numeric_limits<double>::infinity();
                      };
                      for (Neighbour& n : around.neighbours) {
                          const PrimitiveId id{n.triangle};
                          const double shift = id < answer ? -bias : id > answer ? bias : 0;
                          const ReportedDepth range = plane_depth(n, projection, {0, 0});
                          n.least_inverse_depth = inverse(range.high + shift);
                          n.greatest_inverse_depth = inverse(range.low + shift);
                          n.gradient = 0;
                      }
                  });
    h.learned_bits = bits_of_a_number;
    h.fits_a_limit = true;
    return {h};
}

enum class Facing { front, back, edge_on };

/// Front faces run counter-clockwise (glTF).
Facing facing_of(const View& view, const CornersWorld& p_world) {
    const auto decide = [&]<class Number>(Number) {
        const ViewRay<Number> ray(view, 0, 0);
        const Corners<Number> p = corners<Number>(p_world);
        const auto normal = cross(p[1] - p[0], p[2] - p[0]);
        const bool perspective = view.camera.projection == Projection::perspective;
        const int side = sign(dot(normal, perspective ? p[0] - ray.origin : ray.direction));
        return side < 0 ? Facing::front : side > 0 ? Facing::back : Facing::edge_on;
    };
    try {
        return decide(Interval());
    } catch (const UndecidedSign&) {
        return decide(Rational());
    }
}

Hypothesis dropped(const DiagnosisInput& input, const std::string& which, Facing facing) {
    return with_rule(input,
                     {which + " faces are dropped",
                      "Triangles seen from the " + which + " are not drawn (counter-clockwise is front).",
                      "Look at face culling and at the winding that counts as front: both sides are seen."},
                     [=](Neighbourhood& around, PrimitiveId) {
                         std::erase_if(around.neighbours, [&](const Neighbour& n) {
                             return facing_of(around.view, n.p_world) == facing;
                         });
                     });
}

Hypothesis clipped_at(const DiagnosisInput& input, const Cause& cause, double near_depth, double far_depth) {
    Hypothesis h = as_declared(input, cause);
    h.view.camera.near_depth = near_depth;
    h.view.camera.far_depth = far_depth;
    return h;
}

/// A plane so near that nothing of any size lies before it.
constexpr double next_to_nothing = 0x1p-20;

/// Depths between which everything lies that the camera may see, with room to spare.
struct DepthRange {
    double nearest, farthest;
};

DepthRange all_depths(const Scene& scene, const Camera& camera) {
    DepthRange range{camera.near_depth, camera.far_depth};
    for (const glm::vec3& p : scene.vertices.position_world) {
        const double depth = -dot(camera.back, glm::dvec3(p) - glm::dvec3(camera.eye_world));
        range = {std::min(range.nearest, depth), std::max(range.farthest, depth)};
    }
    const double size = range.farthest - range.nearest;
    return {range.nearest - size, range.farthest + size};
}

std::vector<Hypothesis> of_clipping(const DiagnosisInput& input) {
    const Camera& c = input.view.camera;
    const bool perspective = c.projection == Projection::perspective;
    const DepthRange everything = all_depths(input.scene, c);
    const char* equation =
        "Look at the near plane's equation in clip space: it depends on the range of NDC z.";
    std::vector<Hypothesis> all{clipped_at(
        input, {"the near clip is missing", "What lies between eye and near plane is drawn, too.", equation},
        perspective ? c.near_depth * next_to_nothing : everything.nearest, c.far_depth)};
    if (perspective) {
        const double ratio = c.near_depth / c.far_depth;
        all.push_back(clipped_at(input,
                                 {"the near clip is that of z >= 0 (NDC z is -1 to 1)",
                                  "Clipped where NDC z is 0 although it is -1 on the near plane.", equation},
                                 2 * c.near_depth / (1 + ratio), c.far_depth));
        all.push_back(clipped_at(input,
                                 {"the near clip is that of z >= -w (NDC z is 0 to 1)",
                                  "Clipped where NDC z is -1 although it is 0 on the near plane.", equation},
                                 c.near_depth / (2 - ratio), c.far_depth));
    }
    if (std::isfinite(c.far_depth))
        all.push_back(clipped_at(
            input,
            {"the far clip is missing", "What lies beyond the far plane is drawn, too.",
             "Look at the far plane: depth clamping, or a ray whose end is not far."},
            c.near_depth, perspective ? std::numeric_limits<double>::infinity() : everything.farthest));
    return all;
}

/// Seen by the reference and nowhere in the candidate's frame.
std::unordered_set<std::uint32_t> never_drawn(const DiagnosisInput& input) {
    std::unordered_set<std::uint32_t> missing;
    for (const PrimitiveId id : input.reference.frame.primitive.pixels())
        if (id != PrimitiveId::none) missing.insert(std::uint32_t(id));
    for (const PrimitiveId id : input.candidate.frame.primitive.pixels()) missing.erase(std::uint32_t(id));
    return missing;
}

Hypothesis lost_triangles(const DiagnosisInput& input) {
    const std::unordered_set<std::uint32_t> missing = never_drawn(input);
    Hypothesis h =
        with_rule(input,
                  {"some triangles are not drawn",
                   "Triangles that the reference sees, and this renderer nowhere, are taken for absent.",
                   "Look at lists with a fixed size, at binning, and at loops that end one too early."},
                  [missing](Neighbourhood& around, PrimitiveId) {
                      std::erase_if(around.neighbours,
                                    [&](const Neighbour& n) { return missing.contains(n.triangle); });
                  });
    h.learned_bits = double(missing.size()) * bits_of_an_id(input);
    h.supposes_no_rule = true;
    return h;
}

/// Objects of which the reference shows something, and the candidate nothing.
std::vector<Part> parts_never_drawn(const DiagnosisInput& input) {
    const auto triangles_of = [](const Frame& frame) {
        std::vector<std::uint32_t> shown;
        for (const PrimitiveId id : frame.primitive.pixels())
            if (shown.empty() || shown.back() != std::uint32_t(id)) shown.push_back(std::uint32_t(id));
        std::ranges::sort(shown);
        return shown;
    };
    const std::vector<std::uint32_t> ours = triangles_of(input.candidate.frame),
                                     theirs = triangles_of(input.reference.frame);
    const auto is_shown = [](const Part& part, const std::vector<std::uint32_t>& shown) {
        const auto first = std::ranges::lower_bound(shown, part.first_triangle);
        return first != shown.end() && *first - part.first_triangle < part.triangle_count;
    };
    std::vector<Part> parts;
    std::ranges::copy_if(input.scene.parts, std::back_inserter(parts),
                         [&](const Part& part) { return is_shown(part, theirs) && !is_shown(part, ours); });
    return parts;
}

/// Which parts they are takes no more bits than which hypothesis it is.
std::vector<Hypothesis> lost_parts(const DiagnosisInput& input) {
    if (input.said && input.said->labels.are_absent) return {};  // who stands for a depth is no proof
    const std::vector<Part> parts = parts_never_drawn(input);
    if (parts.empty() || parts.size() == input.scene.parts.size()) return {};
    Hypothesis h = with_rule(
        input,
        {"some parts are not drawn", "Nothing is drawn of " + joined(parts, ", ", &Part::node) + ".",
         "Look at the list of draw calls, at what is visible, and at what failed to load."},
        [parts](Neighbourhood& around, PrimitiveId) {
            std::erase_if(around.neighbours, [&](const Neighbour& n) {
                return std::ranges::any_of(parts, [&](const Part& part) {
                    return n.triangle - part.first_triangle < part.triangle_count;
                });
            });
        });
    h.supposes_no_rule = h.tells_numbers = true;
    return {h};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_drawing(const DiagnosisInput& input) {
    std::vector<Hypothesis> all = of_clipping(input);
    all.push_back(dropped(input, "back", Facing::back));
    all.push_back(dropped(input, "front", Facing::front));
    for (Hypothesis& h : of_the_depth_test(input)) all.push_back(std::move(h));
    for (Hypothesis& h : biased_test(input)) all.push_back(std::move(h));
    for (Hypothesis& h : lost_parts(input)) all.push_back(std::move(h));
    all.push_back(lost_triangles(input));
    return all;
}

}  // namespace zproof
