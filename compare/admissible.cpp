#include "compare/admissible.h"

#include <cmath>

#include "compare/coplanar.h"
#include "math/interval.h"
#include "math/rational.h"

namespace zproof {

namespace {

constexpr int no_edge = -1;  ///< an id that no line has

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
    const auto [low, high] =
        std::minmax({corner_id(p_world[(edge + 1) % 3]), corner_id(p_world[(edge + 2) % 3])});
    const int id = edge_ids_.try_emplace({low, high}, int(edge_ids_.size())).first->second;
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
        for (const Affine<Number>& f :
             {segment->line, -segment->line, segment->after_start, segment->before_end})
            if (region) region = region->inside(*new_line(f));
        push_clipped(pieces, std::move(region), segment->nearness, index);
    }
    return pieces;
}

template <class Number>
auto AdmissibleSet<Number>::shared_edge(size_t a, size_t b) const -> std::optional<LinePointer> {
    if (!drawn_[a].image || !drawn_[b].image) return std::nullopt;
    for (const LinePointer edge : drawn_[a].edge)
        if (std::ranges::count(drawn_[b].edge, edge->id, &Line<Number>::id)) return edge;
    return std::nullopt;
}

template <class Number>
bool AdmissibleSet<Number>::are_on_one_side(size_t a, size_t b, int edge_id) const {
    const Affine<Number>& f = (*std::ranges::find(drawn_[a].edge, edge_id, &Line<Number>::id))->f;
    const Affine<Number>& g = (*std::ranges::find(drawn_[b].edge, edge_id, &Line<Number>::id))->f;
    return sign(f.a * g.a + f.b * g.b) > 0;
}

/// Does another occluder lie beyond this edge, so that no displacement can open it?
template <class Number>
bool AdmissibleSet<Number>::continues(LinePointer edge, size_t owner,
                                      const std::vector<size_t>& occluders) const {
    return std::ranges::any_of(occluders, [&](size_t other) {
        return other != owner && std::ranges::count(drawn_[other].edge, edge->id, &Line<Number>::id) &&
               !are_on_one_side(owner, other, edge->id);
    });
}

template <class Number>
auto AdmissibleSet<Number>::moved_inwards(LinePointer edge) -> LinePointer {
    Affine<Number> moved = edge->f;
    moved.c = moved.c - Number(around_.eps_px) * (magnitude(moved.a) + magnitude(moved.b));
    return new_line(moved);
}

/// At the pixel: is the occluder's least nearness above the greatest of what is seen (bounded), or its true
/// nearness not below (strict)?
template <class Number>
bool AdmissibleSet<Number>::is_in_front(size_t occluder, size_t seen, DepthRule rule) const {
    const Neighbour &front = around_.neighbours[occluder], &back = around_.neighbours[seen];
    if (rule == DepthRule::bounded) return front.least_nearness > back.greatest_nearness;
    if (!drawn_[seen].image) return front.least_nearness > back.greatest_nearness;
    if (coplanar(front.p_world, back.p_world)) return true;
    return sign(drawn_[occluder].image->nearness.c - drawn_[seen].image->nearness.c) >= 0;
}

template <class Number>
std::vector<size_t> AdmissibleSet<Number>::in_front_of(size_t seen, DepthRule rule) const {
    std::vector<size_t> occluders;
    for (size_t i = 0; i < drawn_.size(); ++i)
        if (i != seen && drawn_[i].image && is_in_front(i, seen, rule)) occluders.push_back(i);
    return occluders;
}

/// The part of the image that an occluder covers for certain, bounded by all its edges but `free_edge`.
template <class Number>
HalfPlanes<Number> AdmissibleSet<Number>::cover(size_t occluder, const std::vector<size_t>& occluders,
                                                EdgeRule rule, int free_edge) {
    HalfPlanes<Number> half_planes;
    for (const LinePointer edge : drawn_[occluder].edge) {
        if (edge->id == free_edge) continue;
        const bool stays = rule == EdgeRule::watertight || continues(edge, occluder, occluders);
        half_planes.push_back(stays ? edge : moved_inwards(edge));
    }
    for (const Side side : {Side::near, Side::far})
        if (auto line =
                plane(side, drawn_[occluder].image->nearness, around_.neighbours[occluder], Slack::require))
            half_planes.push_back(*line);
    return half_planes;
}

template <class Number>
bool AdmissibleSet<Number>::leaves_square_bare(const std::vector<size_t>& occluders, EdgeRule rule,
                                               std::optional<size_t> seen) {
    std::vector<Region<Number>> left{square()};
    for (const size_t o : occluders) {
        const auto shared = seen ? shared_edge(o, *seen) : std::nullopt;
        if (shared && !are_on_one_side(o, *seen, (*shared)->id)) continue;
        left = without(left, cover(o, occluders, rule, shared ? (*shared)->id : no_edge));
        if (left.empty()) return false;
    }
    return true;
}

template <class Number>
bool AdmissibleSet<Number>::holds(size_t index, Rules rules) {
    return reaches(index) && leaves_square_bare(in_front_of(index, rules.depth), rules.edges, index);
}

template <class Number>
bool AdmissibleSet<Number>::holds_background(EdgeRule edges) {
    std::vector<size_t> drawn;
    for (size_t i = 0; i < drawn_.size(); ++i)
        if (drawn_[i].image) drawn.push_back(i);
    return leaves_square_bare(drawn, edges, std::nullopt);
}

/// Where the occluder's true image is not behind what is seen.
template <class Number>
HalfPlanes<Number> AdmissibleSet<Number>::true_cover(size_t occluder, const Piece& seen) {
    HalfPlanes<Number> half_planes = cover(occluder, {}, EdgeRule::watertight, no_edge);
    if (!coplanar(around_.neighbours[occluder].p_world, around_.neighbours[seen.index].p_world))
        half_planes.push_back(new_line(drawn_[occluder].image->nearness - seen.nearness));
    return half_planes;
}

template <class Number>
bool AdmissibleSet<Number>::is_visible(size_t index) {
    const auto pieces = seen_pieces(index);
    return std::ranges::any_of(pieces, [&](const Piece& piece) {
        std::vector<Region<Number>> left{piece.region};
        for (size_t i = 0; i < drawn_.size() && !left.empty(); ++i)
            if (i != index && drawn_[i].image) left = without(left, true_cover(i, piece));
        return !left.empty();
    });
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
