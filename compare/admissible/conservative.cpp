#include "compare/admissible/conservative.h"

#include <algorithm>
#include <cmath>

#include "compare/admissible/coplanar.h"

namespace zproof {

namespace {

double reach(const Affine<double>& f, double half_side_px) {
    return half_side_px * (std::abs(f.a) + std::abs(f.b));
}

double value_at(const Affine<double>& f, const PixelOffset& at) { return f.at(at.x, at.y); }

/// The inverse depth of the near or far plane moved inwards by its slack, as AdmissibleSet has it; what no
/// triangle keeps to where nothing is left between them.
struct PlaneLimits {
    double near, far;
};
PlaneLimits limits_of(const Camera& c, const Neighbour& n) {
    const bool perspective = c.projection == Projection::perspective;
    const double near = c.near_depth + n.near_slack, far = c.far_depth - n.far_slack;
    const bool is_none_left = far <= (perspective ? 0 : -unlimited);
    return {std::isinf(near) ? -unlimited : inverse_depth_of(near, c.projection),
            is_none_left      ? unlimited
            : std::isinf(far) ? -unlimited
                              : inverse_depth_of(far, c.projection)};
}

}  // namespace

ConservativeTest::ConservativeTest(const Neighbourhood& around, PrimitiveId answer)
    : around_(around),
      error_scale_(2 * std::max(1.0, around.eps_px)),
      is_asked_(std::isfinite(around.eps_px)) {
    others_.reserve(around.neighbours.size());
    for (const Neighbour& n : around.neighbours) {
        const bool is_answer = PrimitiveId(n.triangle) == answer;
        if (!is_answer && misses(n, around.eps_px)) continue;
        const bool is_clear = (n.is_trusted || !is_answer) && is_clear_of_planes(n);
        is_asked_ &= is_clear;
        if (is_answer)
            answer_ = &n;
        else if (!n.may_be_missing)
            others_.push_back(&n);
    }
    is_asked_ &= answer == PrimitiveId::none || answer_;
}

/// Does the triangle miss the square for certain? Where the sign of its edges is not certain, edges of both
/// signs must say so.
bool ConservativeTest::misses(const Neighbour& n, double half_side_px) const {
    const bool is_outside = std::ranges::any_of(
        n.edges, [&](const Affine<double>& e) { return e.c + reach(e, half_side_px) < -edge_error(n); });
    return is_outside && (n.is_trusted || std::ranges::any_of(n.edges, [&](const Affine<double>& e) {
                              return e.c - reach(e, half_side_px) > edge_error(n);
                          }));
}

bool ConservativeTest::is_inside_all_over(const Neighbour& n, std::size_t edge, double half_side_px) const {
    const Affine<double>& e = n.edges[edge];
    return e.c - reach(e, half_side_px) > edge_error(n);
}

bool ConservativeTest::is_inside(const Neighbour& n, const PixelOffset& at) const {
    return std::ranges::all_of(n.edges, [&](const auto& e) { return value_at(e, at) > edge_error(n); });
}

bool ConservativeTest::is_outside(const Neighbour& n, const PixelOffset& at) const {
    const auto is_below = [&](const Affine<double>& e) { return value_at(e, at) < -edge_error(n); };
    const auto is_above = [&](const Affine<double>& e) { return value_at(e, at) > edge_error(n); };
    return std::ranges::any_of(n.edges, is_below) && (n.is_trusted || std::ranges::any_of(n.edges, is_above));
}

/// By its plane; not where its range says that it hides the answer, as under another rule of drawing.
bool ConservativeTest::is_behind_answer(const Neighbour& n, const PixelOffset& at) const {
    return n.image && n.least_inverse_depth <= answer_->greatest_inverse_depth &&
           value_at(answer_->image->inverse_depth - n.image->inverse_depth, at) >
               inverse_depth_error(n) + inverse_depth_error(*answer_);
}

/// Does no plane cut it in the square?
bool ConservativeTest::is_clear_of_planes(const Neighbour& n) const {
    const Camera& c = around_.view.camera;
    return (n.nearest > c.near_depth && n.farthest < c.far_depth) ||
           (n.is_trusted && keeps_between_planes(n, around_.eps_px));
}

/// Does it keep between near and far, each moved inwards by its slack, all over the square?
bool ConservativeTest::keeps_between_planes(const Neighbour& n, double half_side_px) const {
    const Affine<double>& inverse_depth = n.image->inverse_depth;
    const PlaneLimits limits = limits_of(around_.view.camera, n);
    const double unsure = reach(inverse_depth, half_side_px) + inverse_depth_error(n);
    return inverse_depth.c + unsure < limits.near && inverse_depth.c - unsure > limits.far;
}

/// Does nothing hide the answer there, whatever the rule? What is outside or behind is in no set that hides.
bool ConservativeTest::is_seen_at(const PixelOffset& at) const {
    if (answer_ && !is_inside(*answer_, at)) return false;
    return std::ranges::all_of(others_, [&](const Neighbour* n) {
        return is_outside(*n, at) || (answer_ && is_behind_answer(*n, at));
    });
}

/// Does nothing hide the answer there by the bounded rule?
bool ConservativeTest::is_held_at(const PixelOffset& at) const {
    return is_inside(*answer_, at) && std::ranges::all_of(others_, [&](const Neighbour* n) {
               return is_outside(*n, at) || n->least_inverse_depth <= answer_->greatest_inverse_depth;
           });
}

/// The square's corners and the middles of its sides, and for a triangle the middle of its part of the
/// square.
template <class IsThere>
bool ConservativeTest::is_anywhere(double half_side_px, const IsThere& is_there) const {
    const double h = half_side_px;
    for (const PixelOffset& at :
         {PixelOffset{-h, -h}, {h, -h}, {-h, h}, {h, h}, {-h, 0}, {h, 0}, {0, -h}, {0, h}})
        if (is_there(at)) return true;
    if (!answer_) return false;
    const Part part = part_in(h);
    if (part.count < 3) return false;
    const PixelOffset middle = part.middle();
    return is_there({std::clamp(middle.x, -h, h), std::clamp(middle.y, -h, h)});
}

bool ConservativeTest::is_seen_around(double half_side_px) const {
    return is_anywhere(half_side_px, [&](const PixelOffset& at) { return is_seen_at(at); });
}

/// Does one triangle take all of the answer away there, by the strict rule and by true visibility?
bool ConservativeTest::is_hidden_in(double half_side_px) const {
    return std::ranges::any_of(others_, [&](const Neighbour* n) {
        return covers_answer_in(*n, half_side_px) && (!answer_ || hides_in(*n, half_side_px));
    });
}

/// Does it cover what the answer has of the square: are all its edges that may pass there the answer's, too?
bool ConservativeTest::covers_answer_in(const Neighbour& n, double half_side_px) const {
    if (!n.is_trusted) return false;
    for (std::size_t edge = 0; edge < 3; ++edge)
        if (!is_inside_all_over(n, edge, half_side_px) && !shares_edge(n, edge)) return false;
    return keeps_between_planes(n, half_side_px);
}

/// Has the answer that edge as well, and lie both on the same side of it?
bool ConservativeTest::shares_edge(const Neighbour& n, std::size_t edge) const {
    if (!answer_) return false;
    const glm::vec3 &from = n.p_world[(edge + 1) % 3], &to = n.p_world[(edge + 2) % 3];
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec3 &start = answer_->p_world[(k + 1) % 3], &end = answer_->p_world[(k + 2) % 3];
        if (!(from == start && to == end) && !(from == end && to == start)) continue;
        const Affine<double>&e = n.edges[edge], &f = answer_->edges[k];
        return e.a * f.a + e.b * f.b > 0;
    }
    return false;
}

bool ConservativeTest::hides_in(const Neighbour& n, double half_side_px) const {
    if (n.greatest_inverse_depth < answer_->least_inverse_depth) return false;
    const Affine<double> ahead = n.image->inverse_depth - answer_->image->inverse_depth;
    const bool is_in_front =
        ahead.c - reach(ahead, half_side_px) > inverse_depth_error(n) + inverse_depth_error(*answer_);
    return is_in_front || coplanar(n.p_world, answer_->p_world);
}

auto ConservativeTest::finding() const -> Finding {
    if (!is_asked_) return Finding::undecided;
    const PixelOffset centre{0, 0};
    const double eps_px = around_.eps_px;
    if (is_seen_at(centre)) return Finding::visible;
    if (answer_ && is_hidden_in(eps_px)) {
        const auto is_held = [&](const PixelOffset& at) { return is_held_at(at); };
        return is_held(centre) || is_anywhere(eps_px, is_held) ? Finding::tied : Finding::undecided;
    }
    return is_seen_around(least_px(eps_px)) || is_seen_around(eps_px) ? Finding::visible : Finding::undecided;
}

auto ConservativeTest::seen_within(double half_side_px) const -> Visibility {
    if (!is_asked_) return Visibility::undecided;
    if (is_seen_at({0, 0}) || is_seen_around(half_side_px)) return Visibility::yes;
    if (is_hidden_in(half_side_px)) return Visibility::no;
    // rounding may show it in the whole square all the same
    if (answer_ && half_side_px < around_.eps_px && misses(*answer_, half_side_px)) return Visibility::no;
    return Visibility::undecided;
}

/// The part of the answer in the square, clipped edge by edge; inexact by rounding.
auto ConservativeTest::part_in(double half_side_px) const -> Part {
    const double h = half_side_px;
    Part part{{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}}, 4};
    for (const Affine<double>& e : answer_->edges) {
        Part kept;
        const auto keep = [&](const PixelOffset& at) {
            if (kept.count < kept.corner.size()) kept.corner[kept.count++] = at;
        };
        for (std::size_t k = 0; k < part.count; ++k) {
            const PixelOffset &p = part.corner[k], &q = part.corner[(k + 1) % part.count];
            const double at_p = value_at(e, p), at_q = value_at(e, q), t = at_p / (at_p - at_q);
            if (at_p >= 0) keep(p);
            if ((at_p >= 0) != (at_q >= 0)) keep({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
        part = kept;
    }
    return part;
}

PixelOffset ConservativeTest::Part::middle() const {
    PixelOffset sum{0, 0};
    for (std::size_t k = 0; k < count; ++k) sum = {sum.x + corner[k].x, sum.y + corner[k].y};
    return {sum.x / double(count), sum.y / double(count)};
}

}  // namespace zproof
