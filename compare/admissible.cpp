#include "compare/admissible.h"

#include <cmath>

#include "compare/coplanar.h"
#include "math/interval.h"
#include "math/rational.h"

namespace zproof {

namespace {

template <class Number>
Affine<Number> constant(double value) {
    return {Number(0), Number(0), Number(value)};
}

template <class Number>
Number magnitude(const Number& n) {
    return sign(n) < 0 ? Number(-n) : n;
}
Interval magnitude(const Interval& n) {
    if (n.low() >= 0) return n;
    if (n.high() <= 0) return -n;
    return {0, std::max(-n.low(), n.high())};
}

}  // namespace

template <class Number>
AdmissibleSet<Number>::AdmissibleSet(const Neighbourhood& around)
    : around_(around), sight_(around.view, around.x, around.y) {
    const Number h(around.eps_px), zero(0), one(1);
    sides_ = {new_line({zero, one, h}), new_line({-one, zero, h}), new_line({zero, -one, h}),
              new_line({one, zero, h})};
    for (const Neighbour& n : around_.neighbours) drawn_.push_back(draw(n));
}

template <class Number>
auto AdmissibleSet<Number>::new_line(const Affine<Number>& f) -> LinePointer {
    const int id = -2 - int(lines_.size());  // below the ids of mesh edges
    return &lines_.emplace_back(Line<Number>{f, id, {-1, -1}});
}

template <class Number>
int AdmissibleSet<Number>::corner_id(const glm::vec3& p_world) {
    const auto found = std::ranges::find(corner_positions_, p_world);
    if (found == corner_positions_.end()) corner_positions_.push_back(p_world);
    return int(std::ranges::find(corner_positions_, p_world) - corner_positions_.begin());
}

template <class Number>
auto AdmissibleSet<Number>::edge_line(const Affine<Number>& f, const CornersWorld& p_world, size_t edge)
    -> LinePointer {
    const auto [low, high] = std::minmax({corner_id(p_world[(edge + 1) % 3]), corner_id(p_world[(edge + 2) % 3])});
    const int id = edge_ids_.try_emplace({low, high}, int(edge_ids_.size())).first->second;
    ++edge_count_[id];
    return &lines_.emplace_back(Line<Number>{f, id, {low, high}});
}

template <class Number>
auto AdmissibleSet<Number>::draw(const Neighbour& neighbour) -> Drawn {
    Drawn drawn{image_of(sight_, corners<Number>(neighbour.p_world))};
    if (drawn.image)
        for (size_t i = 0; i < 3; ++i) drawn.edge[i] = edge_line(drawn.image->edge[i], neighbour.p_world, i);
    return drawn;
}

template <class Number>
Region<Number> AdmissibleSet<Number>::square() {
    return Region<Number>::square(sides_, Number(around_.eps_px));
}

/// The half-plane on the lawful side of the near or far plane. `admit` moves the plane outwards by its slack,
/// `require` inwards. None where the plane cannot cut.
template <class Number>
auto AdmissibleSet<Number>::plane(Side side, const Affine<Number>& nearness, const Neighbour& n, Slack slack)
    -> std::optional<LinePointer> {
    const Camera& c = around_.view.camera;
    const bool near = side == Side::near;
    const double outwards = (slack == Slack::admit ? 1 : -1) * (near ? -n.near_slack : n.far_slack);
    const double depth = (near ? c.near_depth : c.far_depth) + outwards;
    const bool perspective = c.projection == Projection::perspective;
    if (std::isinf(depth) || (perspective && depth <= 0)) return std::nullopt;
    const Affine<Number> limit = constant<Number>(perspective ? 1 / depth : -depth);
    return new_line(near ? limit - nearness : nearness - limit);
}

template <class Number>
void AdmissibleSet<Number>::push_clipped(std::vector<Piece>& pieces, std::optional<Region<Number>> region,
                                         const Affine<Number>& nearness, size_t index) {
    for (const Side side : {Side::near, Side::far}) {
        const auto line = plane(side, nearness, around_.neighbours[index], Slack::admit);
        if (region && line) region = region->inside(**line);
    }
    if (region) pieces.push_back({std::move(*region), nearness, index});
}

template <class Number>
auto AdmissibleSet<Number>::seen_pieces(size_t index) -> std::vector<Piece> {
    const Drawn& drawn = drawn_[index];
    if (!drawn.image) return edge_on_pieces(index);
    std::optional<Region<Number>> region = square();
    for (const LinePointer edge : drawn.edge)
        if (region) region = region->inside(*edge);
    std::vector<Piece> pieces;
    push_clipped(pieces, std::move(region), drawn.image->nearness, index);
    return pieces;
}

template <class Number>
auto AdmissibleSet<Number>::edge_on_pieces(size_t index) -> std::vector<Piece> {
    const Corners<Number> p_world = corners<Number>(around_.neighbours[index].p_world);
    std::vector<Piece> pieces;
    for (size_t i = 0; i < 3; ++i) {
        const auto segment = segment_image(sight_, p_world[i], p_world[(i + 1) % 3]);
        if (!segment) continue;
        std::optional<Region<Number>> region = square();
        for (const Affine<Number>& f : {segment->line, -segment->line, segment->after_start, segment->before_end})
            if (region) region = region->inside(*new_line(f));
        push_clipped(pieces, std::move(region), segment->nearness, index);
    }
    return pieces;
}

template <class Number>
auto AdmissibleSet<Number>::covering_edge(LinePointer edge, EdgeRule rule) -> LinePointer {
    if (rule == EdgeRule::as_is || is_shared(edge)) return edge;
    const Number eps(around_.eps_px);
    Affine<Number> moved = edge->f;
    moved.c = moved.c - eps * (magnitude(moved.a) + magnitude(moved.b));
    return new_line(moved);
}

/// The part of the image that a triangle covers for certain.
template <class Number>
HalfPlanes<Number> AdmissibleSet<Number>::covering(size_t index, EdgeRule rule) {
    HalfPlanes<Number> half_planes;
    for (const LinePointer edge : drawn_[index].edge) half_planes.push_back(covering_edge(edge, rule));
    for (const Side side : {Side::near, Side::far})
        if (auto line = plane(side, drawn_[index].image->nearness, around_.neighbours[index], Slack::require))
            half_planes.push_back(*line);
    return half_planes;
}

/// >= 0 where the occluder is in front of what is seen: by more than both bounds, or strictly by their exact places.
template <class Number>
Affine<Number> AdmissibleSet<Number>::lead(size_t occluder, const Piece& seen, DepthRule rule) {
    const Neighbour& near_one = around_.neighbours[occluder];
    const Neighbour& far_one = around_.neighbours[seen.index];
    const Affine<Number>& nearness = drawn_[occluder].image->nearness;
    if (rule == DepthRule::strict) {
        if (coplanar(near_one.p_world, far_one.p_world)) return constant<Number>(0);
        return nearness - seen.nearness;
    }
    const bool perspective = sight_.projection == Projection::perspective;
    // perspective: 1/depth is off by the factor 1 -+ r; parallel: depth by 1 +- r and by the absolute share
    const auto relative = [&](const Neighbour& n, double nearest) {
        return n.bounds.depth_relative + (perspective ? n.bounds.depth_absolute * nearest : 0);
    };
    const auto shift = [&](const Neighbour& n) {
        return n.bounds.depth_eps_px * n.gradient + (perspective ? 0 : n.bounds.depth_absolute);
    };
    const double sense = perspective ? 1 : -1;
    const Number low = Number(1) - Number(sense * relative(near_one, near_one.highest_nearness));
    const Number high = Number(1) + Number(sense * relative(far_one, far_one.highest_nearness));
    return low * nearness - high * seen.nearness - constant<Number>(shift(near_one) + shift(far_one));
}

template <class Number>
bool AdmissibleSet<Number>::visible(const Piece& piece, Rules rules) {
    std::vector<Region<Number>> left{piece.region};
    for (size_t i = 0; i < drawn_.size() && !left.empty(); ++i) {
        if (i == piece.index || !drawn_[i].image) continue;
        HalfPlanes<Number> hiding = covering(i, rules.edges);
        hiding.push_back(new_line(lead(i, piece, rules.depth)));
        left = without(left, hiding);
    }
    return !left.empty();
}

template <class Number>
bool AdmissibleSet<Number>::holds(size_t index, Rules rules) {
    const auto pieces = seen_pieces(index);
    return std::ranges::any_of(pieces, [&](const Piece& piece) { return visible(piece, rules); });
}

template <class Number>
bool AdmissibleSet<Number>::holds_background(EdgeRule edges) {
    std::vector<Region<Number>> left{square()};
    for (size_t i = 0; i < drawn_.size() && !left.empty(); ++i)
        if (drawn_[i].image) left = without(left, covering(i, edges));
    return !left.empty();
}

template <class Number>
bool AdmissibleSet<Number>::is_clipped(size_t index) {
    if (!drawn_[index].image) return false;
    std::optional<Region<Number>> region = square();
    for (const LinePointer edge : drawn_[index].edge)
        if (region) region = region->inside(*edge);
    if (!region) return false;
    for (const Side side : {Side::near, Side::far})
        if (auto line = plane(side, drawn_[index].image->nearness, around_.neighbours[index], Slack::require))
            if (region->outside(**line)) return true;
    return false;
}

template class AdmissibleSet<Interval>;
template class AdmissibleSet<Rational>;

}  // namespace zproof
