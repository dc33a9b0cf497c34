#include "compare/admissible/admissible_set.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <type_traits>

#include "compare/admissible/cut_polygon.h"
#include "compare/admissible/weights.h"
#include "math/interval.h"
#include "math/lazy_rational.h"

namespace zproof {

namespace {

template <class Number>
Affine<Number> constant(double value) {
    return {Number(0), Number(0), Number(value)};
}

/// Does it work out what others know: on which side of a shared edge a plane is nearer, that a line and its
/// other side are one, that what covers by one rule covers by another? So the others can be held against it.
template <class Number>
constexpr bool takes_nothing_for_granted = std::is_same_v<Number, Rational>;

/// The evidence holds the image in double.
template <class Number>
std::optional<TriangleImage<Number>> image_of_neighbour(const ViewRay<Number>& ray,
                                                        const Neighbour& neighbour) {
    if constexpr (std::is_same_v<Number, double>)
        return neighbour.image;
    else
        return image_of(ray, corners<Number>(neighbour.p_world));
}

/// How far beyond its edges a triangle counts as inside at the centre, by its weights' tolerance.
double tolerated_px(const Neighbourhood& around, const Neighbour& n) {
    if (n.weight_tolerance == 0) return 0;
    const auto weights = weights_of(ViewRay<double>(around.view, around.x, around.y), n);
    const double allowed = n.weight_tolerance * std::abs(weights[0].c + weights[1].c + weights[2].c);
    double largest = 0;
    for (const Affine<double>& f : weights)
        largest = std::max(largest, allowed / (std::abs(f.a) + std::abs(f.b)));
    return largest;
}

}  // namespace

template <class Number>
AdmissibleSet<Number>::AdmissibleSet(const Neighbourhood& around)
    : around_(around),
      ray_(around.view, around.x, around.y),
      drawn_(around.neighbours.size()),
      pieces_(around.neighbours.size()),
      front_to_back_(around.neighbours.size()) {
    set_half_side(around.eps_px);
    std::iota(front_to_back_.begin(), front_to_back_.end(), size_t(0));
    std::ranges::stable_sort(front_to_back_, std::greater<>{},
                             [&](size_t i) { return around_.neighbours[i].least_inverse_depth; });
}

template <class Number>
void AdmissibleSet<Number>::set_half_side(double half_side_px) {
    half_side_px_ = half_side_px;
    std::ranges::fill(pieces_, std::nullopt);
    covering_.reset();
    sides_ = sides_of_square(half_side_px);
}

template <class Number>
auto AdmissibleSet<Number>::sides_of_square(double half_side_px) -> std::array<LinePointer, 4> {
    const Number h(half_side_px), zero(0), one(1);
    return {new_line({zero, one, h}), new_line({-one, zero, h}), new_line({zero, -one, h}),
            new_line({one, zero, h})};
}

/// Displacement counts by what is left of eps; its edges are moved outwards by their own errors, and to where
/// their weight is minus the tolerance. Where their errors exceed its width, the computed orientation may be
/// the other one.
template <class Number>
bool AdmissibleSet<Number>::is_inside_by_rounding(size_t index) {
    const Neighbour& n = around_.neighbours[index];
    if (!n.may_be_shown_by_rounding()) return false;
    const double outwards_px = std::ranges::max(n.edge_rounding_px) + tolerated_px(around_, n),
                 moved_px = std::max(0.0, std::min(n.bounds.eps_px, around_.eps_px) - outwards_px);
    if (!std::isfinite(outwards_px + moved_px)) return false;
    const auto weights = weights_of(ray_, n);
    const Affine<Number> sum = weights[0] + weights[1] + weights[2];
    for (const bool is_turned : {false, true}) {
        std::optional<Region<Number>> region =
            Region<Number>::square(sides_of_square(moved_px), Number(moved_px));
        for (size_t i = 0; i < 3; ++i) {
            Affine<Number> f = weights[i] + Number(n.weight_tolerance) * sum;
            if (is_turned) f = -f;
            f.c = f.c + Number(n.edge_rounding_px[i]) * (magnitude(weights[i].a) + magnitude(weights[i].b));
            if (region) region = region->inside(*new_line(f));
        }
        std::vector<Piece> shown;
        if (drawn(index).image) push_clipped(shown, region, drawn(index).image->inverse_depth, index);
        if (drawn(index).image ? !shown.empty() : region.has_value()) return true;
    }
    return false;
}

template <class Number>
auto AdmissibleSet<Number>::new_line(const Affine<Number>& f) -> LinePointer {
    const int id = -2 - int(lines_.size());  // below the ids of mesh edges
    return &lines_.emplace_back(Line<Number>{f, id, {-1, -1}});
}

template <class Number>
auto AdmissibleSet<Number>::reversed(LinePointer line) -> LinePointer {
    return &lines_.emplace_back(Line<Number>{-line->f, line->id, line->ends, line->locus});
}

template <class Number>
auto AdmissibleSet<Number>::edge_line(const Affine<Number>& f, const CornersWorld& p_world, size_t edge)
    -> LinePointer {
    const glm::vec3 &from = p_world[(edge + 1) % 3], &to = p_world[(edge + 2) % 3];
    const auto corner_id = [&](const glm::vec3& p) {
        return corner_ids_.try_emplace({p.x, p.y, p.z}, int(corner_ids_.size())).first->second;
    };
    const int start = corner_id(from), end = corner_id(to);
    const std::array<int, 2> ends{std::min(start, end), std::max(start, end)};
    const auto [known, is_new] = edge_ids_.try_emplace(ends, int(edges_.size()));
    if (is_new) {
        const Slope slope = slope_of(from, to);
        edges_.push_back({{from, to}, slope, locus_of(from, to, slope)});
    }
    const int id = known->second;
    return &lines_.emplace_back(Line<Number>{f, id, ends, edges_[std::size_t(id)].locus});
}

/// The locus of an edge that is not among the others yet. The estimates in double are left as they are.
template <class Number>
int AdmissibleSet<Number>::locus_of(const glm::vec3& from_world, const glm::vec3& to_world,
                                    const Slope& slope) {
    if constexpr (std::is_same_v<Number, double>) return -1;
    spend(edges_.size() / 128);  // a comparison costs a small part of a cut
    const auto found = std::ranges::find_if(edges_, [&](const MeshEdge& other) {
        const auto& [start, end] = other.ends_world;
        return !are_turned(other.slope, slope) && collinear(start, end, from_world) &&
               collinear(start, end, to_world);
    });
    return found == edges_.end() ? int(edges_.size()) : found->locus;
}

template <class Number>
auto AdmissibleSet<Number>::draw(const Neighbour& neighbour) -> NeighbourImage {
    NeighbourImage drawn{image_of_neighbour(ray_, neighbour)};
    if (drawn.image)
        for (size_t i = 0; i < 3; ++i) drawn.edge[i] = edge_line(drawn.image->edge[i], neighbour.p_world, i);
    return drawn;
}

template <class Number>
Region<Number> AdmissibleSet<Number>::square() {
    return Region<Number>::square(sides_, Number(half_side_px_));
}

/// The half-plane on the admissible side of the near or far plane. `admit` moves the plane outwards by its
/// slack, `require` inwards. None where the plane cannot cut; no point at all where the slack leaves no depth
/// required.
template <class Number>
auto AdmissibleSet<Number>::plane(ClipSide side, const Affine<Number>& inverse_depth, const Neighbour& n,
                                  Slack slack) -> std::optional<LinePointer> {
    const Camera& c = around_.view.camera;
    const bool near = side == ClipSide::near;
    const double outwards = (slack == Slack::admit ? 1 : -1) * (near ? -n.near_slack : n.far_slack);
    const double depth = (near ? c.near_depth : c.far_depth) + outwards;
    const bool perspective = c.projection == Projection::perspective;
    const bool is_beyond = near ? std::isinf(depth) : depth <= (perspective ? 0 : -HUGE_VAL);
    if (slack == Slack::require && is_beyond) return new_line(constant<Number>(-1));
    if (std::isinf(depth) || (perspective && depth <= 0)) return std::nullopt;
    const Affine<Number> limit = constant<Number>(perspective ? 1 / depth : -depth);
    return new_line(near ? limit - inverse_depth : inverse_depth - limit);
}

template <class Number>
void AdmissibleSet<Number>::push_clipped(std::vector<Piece>& pieces, std::optional<Region<Number>> region,
                                         const Affine<Number>& inverse_depth, size_t index) {
    for (const ClipSide side : {ClipSide::near, ClipSide::far}) {
        const auto line = plane(side, inverse_depth, around_.neighbours[index], Slack::admit);
        if (region && line) region = region->inside(**line);
    }
    if (region) pieces.push_back({std::move(*region), inverse_depth, index});
}

template <class Number>
auto AdmissibleSet<Number>::seen_pieces(size_t index) -> const std::vector<Piece>& {
    if (!pieces_[index]) pieces_[index] = pieces_inside(index);
    return *pieces_[index];
}

template <class Number>
auto AdmissibleSet<Number>::pieces_inside(size_t index) -> std::vector<Piece> {
    if (!drawn(index).image) return edge_on_pieces(index);
    std::optional<Region<Number>> region = square();
    for (const LinePointer edge : drawn(index).edge)
        if (region) region = region->inside(*edge);
    std::vector<Piece> pieces;
    push_clipped(pieces, std::move(region), drawn(index).image->inverse_depth, index);
    return pieces;
}

template <class Number>
auto AdmissibleSet<Number>::edge_on_pieces(size_t index) -> std::vector<Piece> {
    const Corners<Number> p_world = corners<Number>(around_.neighbours[index].p_world);
    std::vector<SegmentImage<Number>> edges;
    for (size_t i = 0; i < 3; ++i)
        if (const auto segment = segment_image(ray_, p_world[i], p_world[(i + 1) % 3]))
            edges.push_back(*segment);
    const auto& [p, q, r] = p_world;
    const bool is_dot = detail::is_zero(q - p) && detail::is_zero(r - p);  // which nothing can part
    if (edges.empty() && !is_dot)
        for (const Vector3<Number>& corner : p_world)
            if (const auto point = point_image(ray_, corner)) edges.push_back(*point);
    std::vector<Piece> pieces;
    for (const SegmentImage<Number>& edge : edges)
        push_clipped(pieces, inside(edge), edge.inverse_depth, index);
    if (around_.neighbours[index].may_be_clipped(around_.view.camera)) push_near_cut(pieces, edges, index);
    return pieces;
}

/// The segment's part in the square.
template <class Number>
std::optional<Region<Number>> AdmissibleSet<Number>::inside(const SegmentImage<Number>& segment) {
    std::optional<Region<Number>> region = square();
    const LinePointer line = new_line(segment.line);
    const LinePointer other_side = takes_nothing_for_granted<Number> ? new_line(-line->f) : reversed(line);
    for (const LinePointer side :
         {line, other_side, new_line(segment.after_start), new_line(segment.before_end)})
        if (region) region = region->inside(*side);
    return region;
}

/// Where the near plane cuts the triangle's inside: beyond it lies one edge, before it another, or the eye
/// within the triangle. The edges may lie before near and beyond far while what is between them does not.
template <class Number>
void AdmissibleSet<Number>::push_near_cut(std::vector<Piece>& pieces,
                                          const std::vector<SegmentImage<Number>>& edges, size_t index) {
    const Neighbour& n = around_.neighbours[index];
    const auto clip = [&](std::optional<Region<Number>>& region, const Affine<Number>& f) {
        if (region) region = region->inside(*new_line(f));
    };
    const bool begins_at_eye = holds_eye(ray_, corners<Number>(n.p_world));
    for (const SegmentImage<Number>& farther : edges) {
        const auto near = plane(ClipSide::near, farther.inverse_depth, n, Slack::admit);
        if (!near) return;
        const Affine<Number> at_near = (*near)->f + farther.inverse_depth;
        std::optional<Region<Number>> beyond = inside(farther);
        if (beyond) beyond = beyond->inside(**near);
        if (begins_at_eye) push_clipped(pieces, beyond, at_near, index);
        for (const SegmentImage<Number>& nearer : edges) {
            std::optional<Region<Number>> between = beyond;
            for (const auto& f : {nearer.after_start, nearer.before_end, nearer.inverse_depth - at_near})
                clip(between, f);
            push_clipped(pieces, std::move(between), at_near, index);
        }
    }
}

template <class Number>
void AdmissibleSet<Number>::spend(std::size_t work) {
    work_ += work;
    if (work_ > around_.most_work) throw TooMuchWork{};
}

template <class Number>
auto AdmissibleSet<Number>::left_of(const std::vector<Region<Number>>& regions,
                                    const HalfPlanes<Number>& half_planes) -> std::vector<Region<Number>> {
    spend(regions.size() * half_planes.size());
    return without(regions, half_planes);
}

template <class Number>
auto AdmissibleSet<Number>::drawn(size_t index) -> const NeighbourImage& {
    if (!drawn_[index]) {
        spend(8);  // an image costs as much as some cuts
        drawn_[index] = draw(around_.neighbours[index]);
    }
    return *drawn_[index];
}

template <class Number>
auto AdmissibleSet<Number>::edge_of(size_t index, int edge_id) -> LinePointer {
    if (!drawn(index).image) return nullptr;
    const auto found = std::ranges::find(drawn(index).edge, edge_id, &Line<Number>::id);
    return found == drawn(index).edge.end() ? nullptr : *found;
}

/// Do both triangles lie on one side of the edge? Nothing where the other triangle does not share it.
template <class Number>
std::optional<bool> AdmissibleSet<Number>::are_on_one_side(LinePointer edge, size_t other) {
    const LinePointer same = edge_of(other, edge->id);
    if (!same) return std::nullopt;
    return sign(edge->f.a * same->f.a + edge->f.b * same->f.b + edge->f.c * same->f.c) > 0;
}

/// Does another occluder lie beyond this edge, so that no displacement can open it?
template <class Number>
bool AdmissibleSet<Number>::continues(LinePointer edge, const std::vector<size_t>& occluders) {
    return std::ranges::any_of(occluders, [&](size_t o) { return !are_on_one_side(edge, o).value_or(true); });
}

/// Does near or far cut the occluder in the square, or does an edge of it pass there that no other of them
/// continues, and that does not move with what is seen? It may part from its surroundings there.
template <class Number>
bool AdmissibleSet<Number>::may_part(size_t occluder, std::optional<size_t> seen,
                                     const std::vector<size_t>& occluders) {
    HalfPlanes<Number> cuts;
    push_planes(cuts, occluder);
    for (const Piece& piece : seen_pieces(occluder)) {
        const auto is_cut_by = [&](LinePointer cut) {
            return piece.region.touches(*cut) || piece.region.outside(*cut).has_value();
        };
        if (std::ranges::any_of(cuts, is_cut_by)) return true;
        for (const LinePointer edge : drawn(occluder).edge) {
            spend(1 + occluders.size() / 128);  // a comparison of ids costs a small part of a cut
            if (!piece.region.touches(*edge) || continues(edge, occluders)) continue;
            if (!seen || !are_on_one_side(edge, *seen).value_or(false)) return true;
        }
    }
    return false;
}

/// The most occluders that no displacement parts within the square: what may part is left out, then what
/// parts without it.
template <class Number>
template <class Occludes>
std::vector<size_t> AdmissibleSet<Number>::watertight_sheet(std::optional<size_t> seen,
                                                            const Occludes& occludes) {
    std::vector<size_t> sheet, kept;
    std::ranges::copy_if(front_to_back_, std::back_inserter(kept), occludes);
    while (kept.size() != sheet.size()) {
        sheet.swap(kept);
        kept.clear();
        std::ranges::copy_if(sheet, std::back_inserter(kept),
                             [&](size_t o) { return !may_part(o, seen, sheet); });
    }
    return sheet;
}

template <class Number>
auto AdmissibleSet<Number>::moved_inwards(LinePointer edge) -> LinePointer {
    Affine<Number> moved = edge->f;
    moved.c = moved.c - Number(half_side_px_) * (magnitude(moved.a) + magnitude(moved.b));
    return new_line(moved);
}

/// Is the occluder's least inverse depth at the pixel above the greatest of what is seen (bounded), or is its
/// true inverse depth not below (strict)?
template <class Number>
bool AdmissibleSet<Number>::is_in_front(size_t occluder, size_t seen, DepthRule rule) {
    const Neighbour &front = around_.neighbours[occluder], &back = around_.neighbours[seen];
    if (front.least_inverse_depth > back.greatest_inverse_depth) return true;
    if (rule == DepthRule::bounded || front.greatest_inverse_depth < back.least_inverse_depth) return false;
    if (!drawn(seen).image || !drawn(occluder).image) return false;
    if (stands_apart(occluder, seen)) return false;  // and so hides none of it: their depths may be equal
    if (meet_at_the_centre(occluder, seen) || coplanar(front.p_world, back.p_world)) return true;
    return sign(drawn(occluder).image->inverse_depth.c - drawn(seen).image->inverse_depth.c) >= 0;
}

template <class Number>
void AdmissibleSet<Number>::push_planes(HalfPlanes<Number>& half_planes, size_t occluder) {
    const Neighbour& n = around_.neighbours[occluder];
    if (!n.may_be_clipped(around_.view.camera)) return;
    for (const ClipSide side : {ClipSide::near, ClipSide::far})
        if (auto line = plane(side, drawn(occluder).image->inverse_depth, n, Slack::require))
            half_planes.push_back(*line);
}

/// The part of the image that an occluder covers for certain; edges that do not stay move inwards by eps. An
/// edge that it shares with what is seen, both on one side of it, moves with that and bounds nothing.
template <class Number>
HalfPlanes<Number> AdmissibleSet<Number>::cover(size_t occluder, std::optional<size_t> seen,
                                                EdgeStays stays) {
    HalfPlanes<Number> half_planes;
    for (const LinePointer edge : drawn(occluder).edge) {
        if (seen && are_on_one_side(edge, *seen).value_or(false)) continue;
        half_planes.push_back(stays == EdgeStays::yes ? edge : moved_inwards(edge));
    }
    const size_t edges = half_planes.size();
    push_planes(half_planes, occluder);
    // what near and far leave is moved as a whole
    if (stays == EdgeStays::no && !around_.clip_windows.empty())
        std::transform(half_planes.begin() + std::ptrdiff_t(edges), half_planes.end(),
                       half_planes.begin() + std::ptrdiff_t(edges),
                       [&](LinePointer f) { return moved_inwards(f); });
    return half_planes;
}

/// Do both share an edge, each on its own side of it? Then a point of one is never a point of the other.
template <class Number>
bool AdmissibleSet<Number>::stands_apart(size_t occluder, size_t seen) {
    return std::ranges::any_of(drawn(occluder).edge,
                               [&](LinePointer edge) { return !are_on_one_side(edge, seen).value_or(true); });
}

/// Does an edge that both share, or a corner, certainly lie at the very centre? Then so do their depths.
template <class Number>
bool AdmissibleSet<Number>::meet_at_the_centre(size_t occluder, size_t seen) {
    std::array<int, 2> ends{-1, -1};  // of the first edge through the centre
    for (const LinePointer edge : drawn(seen).edge) {
        if (!is_certainly_zero(edge->f.c)) continue;
        if (edge_of(occluder, edge->id)) return true;
        for (const int end : edge->ends) {
            const auto ends_there = [&](LinePointer other) {
                return std::ranges::count(other->ends, end) > 0;
            };
            if (std::ranges::count(ends, end) && std::ranges::any_of(drawn(occluder).edge, ends_there))
                return true;
        }
        ends = edge->ends;
    }
    return false;
}

/// Some that cover the square, nearest first: most are covered by the first. Nothing where all leave some of
/// it bare.
template <class Number>
template <class Occludes>
std::optional<std::vector<size_t>> AdmissibleSet<Number>::covered_by(std::optional<size_t> seen,
                                                                     const Occludes& occludes) {
    std::vector<Region<Number>> left{square()};
    std::vector<size_t> occluders;
    for (const size_t o : front_to_back_) {
        if (!occludes(o) || (seen && stands_apart(o, *seen))) continue;
        left = left_of(left, cover(o, seen, EdgeStays::yes));
        occluders.push_back(o);
        if (left.empty()) return occluders;
    }
    return std::nullopt;
}

/// What covered the square by one rule does so by another by which all of it occludes.
template <class Number>
template <class Occludes>
bool AdmissibleSet<Number>::leaves_bare(std::optional<size_t> seen, const Occludes& occludes) {
    if (!takes_nothing_for_granted<Number> && covering_ && covering_->seen == seen &&
        std::ranges::all_of(covering_->occluders, occludes))
        return false;
    auto covering = covered_by(seen, occludes);
    if (!covering) return true;
    covering_ = {seen, std::move(*covering)};
    return false;
}

/// Does the occluder hold the square's centre, with all edges moved inwards?
template <class Number>
bool AdmissibleSet<Number>::holds_centre(size_t occluder, std::optional<size_t> seen) {
    const HalfPlanes<Number> half_planes = cover(occluder, seen, EdgeStays::no);
    spend(half_planes.size());
    return std::ranges::all_of(half_planes, [](LinePointer line) { return sign(line->f.c) > 0; }) &&
           !is_cut_at_the_centre(occluder);
}

/// May the renderer cut the occluder into triangles that share an edge within eps of the square's centre?
/// That edge may end wherever the planes may cut: it is looked at for both ends of each step of theirs, and
/// may not pass the centre between.
template <class Number>
bool AdmissibleSet<Number>::is_cut_at_the_centre(size_t occluder) {
    const Neighbour& n = around_.neighbours[occluder];
    const Camera& c = around_.view.camera;
    if (around_.clip_windows.empty()) return false;
    if (!std::isfinite(n.near_slack + n.far_slack) && n.may_be_clipped(c)) return true;
    const Corners<Number> p_world = corners<Number>(n.p_world);
    const PolygonWorld<Number> triangle(p_world.begin(), p_world.end());
    const double u_per_px = (c.window.right - c.window.left) / around_.view.width,
                 v_per_px = (c.window.top - c.window.bottom) / around_.view.height;
    return std::ranges::any_of(around_.clip_windows, [&](const Window& window) {
        const std::vector<CutPlane<Number>> planes = cut_planes<Number>(
            c, window, {n.near_slack, n.far_slack, half_side_px_ * u_per_px, half_side_px_ * v_per_px});
        return any_cut<Number>(triangle, planes, {triangle}, [&](const auto& polygons) {
            // a polygon of n corners has n (n - 3) / 2 diagonals, each some cuts' work, and was cut itself
            for (const auto& polygon : polygons) spend(polygon.size() * polygon.size());
            return do_diagonals_pass(ray_, Number(half_side_px_), polygons);
        });
    });
}

template <class Number>
template <class Occludes>
bool AdmissibleSet<Number>::leaves_bare_by(EdgeRule rule, std::optional<size_t> seen,
                                           const Occludes& occludes) {
    if (rule == EdgeRule::watertight) return leaves_bare(seen, occludes);
    if (rule == EdgeRule::apart)
        return std::ranges::none_of(front_to_back_, [&](size_t o) {
            return occludes(o) && !(seen && stands_apart(o, *seen)) && holds_centre(o, seen);
        });
    std::vector<bool> is_in_sheet(around_.neighbours.size());
    for (const size_t o : watertight_sheet(seen, occludes)) is_in_sheet[o] = true;
    return leaves_bare(seen, [&](size_t o) { return is_in_sheet[o]; });
}

template <class Number>
bool AdmissibleSet<Number>::holds(size_t index, Rules rules) {
    return is_shown(index) && leaves_bare_by(rules.edges, index, [&](size_t o) {
               return o != index && is_in_front(o, index, rules.depth) && may_occlude(o);
           });
}

template <class Number>
bool AdmissibleSet<Number>::holds_background(EdgeRule edges) {
    return leaves_bare_by(edges, std::nullopt, [&](size_t o) { return may_occlude(o); });
}

/// The half-plane where the occluder's plane, another than that of what is seen, is not behind it. Both
/// planes hold an edge that both triangles share, so that edge parts them in the image.
template <class Number>
auto AdmissibleSet<Number>::nearer_side(size_t occluder, const Piece& seen) -> LinePointer {
    const Affine<Number> ahead = drawn(occluder).image->inverse_depth - seen.inverse_depth;
    if constexpr (takes_nothing_for_granted<Number>) return new_line(ahead);
    for (const LinePointer edge : drawn(occluder).edge) {
        if (!edge_of(seen.index, edge->id)) continue;
        const int side = sign(ahead.a * edge->f.a + ahead.b * edge->f.b + ahead.c * edge->f.c);
        if (side != 0) return side > 0 ? edge : reversed(edge);  // none is only what double has left of it
    }
    return new_line(ahead);
}

/// The region where the occluder's true image is not behind what is seen; nothing where it is behind all over
/// the square.
template <class Number>
std::optional<HalfPlanes<Number>> AdmissibleSet<Number>::true_cover(size_t occluder, const Piece& seen) {
    const Neighbour &front = around_.neighbours[occluder], &back = around_.neighbours[seen.index];
    const double slope = half_side_px_ * (front.gradient + back.gradient);  // what the ranges may lack
    if (front.greatest_inverse_depth + slope < back.least_inverse_depth) return std::nullopt;
    HalfPlanes<Number> half_planes(drawn(occluder).edge.begin(), drawn(occluder).edge.end());
    push_planes(half_planes, occluder);
    const bool certain = front.least_inverse_depth - slope > back.greatest_inverse_depth;
    if (!certain && !coplanar(front.p_world, back.p_world))
        half_planes.push_back(nearer_side(occluder, seen));
    return half_planes;
}

template <class Number>
bool AdmissibleSet<Number>::is_visible(size_t index) {
    return std::ranges::any_of(seen_pieces(index), [&](const Piece& piece) {
        std::vector<Region<Number>> left{piece.region};
        for (const size_t o : front_to_back_) {
            if (o == index || left.empty() || !may_occlude(o)) continue;
            if (const auto hiding = true_cover(o, piece)) left = left_of(left, *hiding);
        }
        return !left.empty();
    });
}

template <class Number>
bool AdmissibleSet<Number>::is_clipped(size_t index) {
    const Neighbour& n = around_.neighbours[index];
    const Camera& c = around_.view.camera;
    // a depth may be uncertain enough for any plane; only one that the corners reach is a plane's doing
    if ((n.nearest > c.near_depth && n.farthest < c.far_depth) || !drawn(index).image) return false;
    if (!reaches(index)) return false;  // all that it has here is cut away for certain
    std::optional<Region<Number>> region = square();
    for (const LinePointer edge : drawn(index).edge)
        if (region) region = region->inside(*edge);
    if (!region) return false;
    for (const ClipSide side : {ClipSide::near, ClipSide::far})
        if (auto line = plane(side, drawn(index).image->inverse_depth, n, Slack::require))
            if (region->outside(**line)) return true;
    return false;
}

template class AdmissibleSet<double>;
template class AdmissibleSet<Interval>;
template class AdmissibleSet<LazyRational>;
template class AdmissibleSet<Rational>;  // for tests: what the others are held against

}  // namespace zproof
