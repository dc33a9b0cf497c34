#include <algorithm>
#include <cmath>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/other_world.h"
#include "compare/diagnosis/hypotheses/plane_depth.h"
#include "math/rational.h"

namespace zproof {

namespace {

constexpr double half_pixel = 0.5;

double slope_sum(const Affine<double>& e) { return std::abs(e.a) + std::abs(e.b); }

/// Does the triangle hold all of the square of that half-side around the centre?
bool holds_square(const Neighbour& n, double half_side) {
    return n.image && std::ranges::all_of(n.image->edge, [&](const Affine<double>& e) {
               return e.c - half_side * slope_sum(e) >= 0;
           });
}

/// Does an edge of the triangle pass the square?
bool may_lie_on_edge(const Neighbourhood& around, const Neighbour& n) {
    return n.image && std::ranges::any_of(n.image->edge, [&](const Affine<double>& e) {
               return std::abs(e.c) <= around.eps_px * slope_sum(e);
           });
}

/// Does an edge pass exactly where the pixel is sampled?
bool lies_on_edge(const Neighbourhood& around, const Neighbour& n) {
    const auto image =
        image_of(ViewRay<Rational>(around.view, around.x, around.y), corners<Rational>(n.p_world));
    return image && std::ranges::any_of(image->edge, [](const auto& e) { return sign(e.c) == 0; });
}

/// Holes only: a pixel that two neighbours both claim shows one of them, admissibly. First where no triangle
/// moves: a centre on an edge is a hole for certain. Then where a triangle may move onto the centre.
std::vector<Hypothesis> without_fill_rule(const DiagnosisInput& input) {
    Hypothesis exact =
        as_declared(input, {"the top-left rule is missing",
                            "A centre exactly on an edge belongs to no triangle: holes along shared edges.",
                            "Look at the edge test: one of two triangles must own a centre on their edge."});
    Hypothesis moved = exact;
    exact.amend = [](Neighbourhood& around, PrimitiveId) {
        std::erase_if(around.neighbours, [&](const Neighbour& n) {
            return may_lie_on_edge(around, n) && lies_on_edge(around, n);
        });
    };
    moved.amend = [](Neighbourhood& around, PrimitiveId answer) {
        std::erase_if(around.neighbours, [&](const Neighbour& n) {
            return PrimitiveId(n.triangle) != answer && may_lie_on_edge(around, n);
        });
    };
    moved.only_permits = true;  // what lies on an edge is known within eps alone
    return {exact, moved};
}

Hypothesis under(const DiagnosisInput& input) {
    Hypothesis h = as_declared(
        input, {"triangles show only where they cover a pixel whole",
                "Coverage asks for all of the pixel's square instead of its centre.",
                "Look at the rasterizer's state: conservative coverage of the inner kind is on."});
    h.amend = [](Neighbourhood& around, PrimitiveId) {
        std::erase_if(around.neighbours, [&](Neighbour& n) {
            n.may_be_missing |= !holds_square(n, half_pixel + around.eps_px);
            return !holds_square(n, half_pixel - around.eps_px);
        });
    };
    return h;
}

/// The least box around the triangle's image, px from the pixel's centre: the image's corners, where two
/// edges meet. Unlimited where one is not before the eye.
Box box_of(const Neighbour& n) {
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
        const Affine<double>&f = n.image->edge[i], &g = n.image->edge[(i + 1) % 3];
        const double divisor = f.a * g.b - f.b * g.a;
        const double x = (f.b * g.c - f.c * g.b) / divisor, y = (f.c * g.a - f.a * g.c) / divisor;
        const Affine<double>& inverse_depth = n.image->inverse_depth;
        const bool is_before_eye =
            divisor != 0 && (inverse_depth.c + inverse_depth.a * x + inverse_depth.b * y > 0);
        if (!is_before_eye) return Box::unlimited();
        box.add(x, y);
    }
    return box;
}

/// Does the triangle meet the square of that half-side around the centre?
bool meets_square(const Neighbour& n, Projection projection, double half_side) {
    if (!n.image) return false;
    const bool passes = std::ranges::all_of(
        n.image->edge, [&](const Affine<double>& e) { return e.c + half_side * slope_sum(e) >= 0; });
    if (!passes || projection == Projection::parallel) return passes;
    return box_of(n).meets({-half_side, -half_side, half_side, half_side});
}

/// The depth of the claimed triangle's plane at the pixel's centre.
ReportedDepth centre_depth(const OtherWorld& world, const View& view, const Claim& claim) {
    const CornersWorld p_world = corners_of(world.scene(), std::uint32_t(claim.answer.primitive));
    const Neighbour n = neighbour_of(ViewRay<double>(view, claim.x, claim.y), world.bounds(), p_world);
    return plane_depth(n, view.camera.projection, {0, 0});
}

/// Is the claim what a renderer says that draws a triangle wherever it touches the pixel's square, at the
/// depth that its plane has at the centre?
bool touches(OtherWorld& world, const View& view, const Claim& claim) {
    const double depth = double(claim.answer.camera_depth);
    const bool is_background = claim.answer.primitive == PrimitiveId::none;
    if (is_background && claim.answer.camera_depth != background_depth) return false;
    if (!is_background) {
        const ReportedDepth own = centre_depth(world, view, claim);
        if (!(own.low <= depth && depth <= own.high)) return false;
    }
    const Neighbourhood around = world.around(claim, 1);
    const Projection projection = view.camera.projection;
    const double certain = half_pixel - around.eps_px, possible = half_pixel + around.eps_px;
    const auto depth_of = [&](const Neighbour& n) { return plane_depth(n, projection, {0, 0}); };
    const auto lies_within = [&](const Neighbour& n) {
        const ReportedDepth range = depth_of(n);
        return range.low > view.camera.near_depth && range.high < view.camera.far_depth;
    };
    const bool is_hidden = std::ranges::any_of(around.neighbours, [&](const Neighbour& n) {
        return PrimitiveId(n.triangle) != claim.answer.primitive && lies_within(n) && !n.may_be_missing &&
               meets_square(n, projection, certain) && depth_of(n).high < depth;
    });
    if (is_hidden || is_background) return !is_hidden;
    const auto place = around.index_of(claim.answer.primitive);
    return place && meets_square(around.neighbours[*place], projection, possible);
}

Hypothesis over(const DiagnosisInput& input) {
    const auto world = std::make_shared<OtherWorld>(input, declared_scene(input), input.view);
    Hypothesis h = decided_by(
        input,
        {"triangles show wherever they touch a pixel",
         "Coverage asks for any part of the pixel's square instead of its centre.",
         "Look at the rasterizer's state: conservative coverage is on."},
        world, [world, view = input.view](const Claim& claim) { return touches(*world, view, claim); },
        [world, view = input.view](const Claim& claim) { return centre_depth(*world, view, claim); });
    h.only_permits = true;  // of coplanar triangles that touch a pixel, any
    return h;
}

/// The last column or row of a triangle's bounding box, or both, are not drawn: those whose centres it
/// holds last, or those that its side lies in.
std::vector<Hypothesis> short_boxes(const DiagnosisInput& input) {
    struct Sides {
        const char* which;
        bool right, bottom;
    };
    std::vector<Hypothesis> all;
    for (const auto& [which, right, bottom] :
         {Sides{"last column", true, false}, Sides{"last row", false, true},
          Sides{"last column and row", true, true}})
        for (const double limit_px : {1.0, half_pixel}) {
            Hypothesis h = as_declared(
                input, {std::string("triangles lose the ") + which + " of their bounding box",
                        limit_px == 1 ? "The last pixels whose centres the box holds are not drawn."
                                      : "The pixels in which the box ends are not drawn.",
                        "Look at the loop over the bounding box: its end belongs to it, or is rounded up."});
            h.amend = [=](Neighbourhood& around, PrimitiveId) {
                std::erase_if(around.neighbours, [&](Neighbour& n) {
                    if (!n.image) return false;
                    const Box box = box_of(n);
                    const double end_px = std::min(right ? box.right : 2, bottom ? box.bottom : 2);
                    n.may_be_missing |= end_px < limit_px + around.eps_px;
                    return end_px < limit_px - around.eps_px;
                });
            };
            all.push_back(std::move(h));
        }
    return all;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_coverage(const DiagnosisInput& input) {
    std::vector<Hypothesis> all = without_fill_rule(input);
    for (Hypothesis& h : std::vector{over(input), under(input)}) all.push_back(std::move(h));
    for (Hypothesis& h : short_boxes(input)) all.push_back(std::move(h));
    return all;
}

}  // namespace zproof
