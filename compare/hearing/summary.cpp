#include "compare/hearing/summary.h"

#include <algorithm>
#include <bit>

#include "compare/truth/displacement.h"

namespace zproof {

namespace {

/// A place of the image, and those that it may have been rounded from.
Around around_place(double x, double y) {
    constexpr double share = 0x1p-50;
    return {x, y, share * (std::abs(x) + 1), share * (std::abs(y) + 1)};
}

/// In the square, where rounding moved it out.
PixelOffset held_within(double half_side_px, const PixelOffset& at) {
    return {std::clamp(at.x, -half_side_px, half_side_px), std::clamp(at.y, -half_side_px, half_side_px)};
}

PixelOffset between(const PixelOffset& p, const PixelOffset& q, double t) {
    return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

double value_at(const Affine<double>& f, double x, double y, double dx, double dy) {
    return f.at(x, y) + (dx * f.a + dy * f.b);
}

}  // namespace

void Summary::Renderer::turn_to(const ViewBounds& to) {
    bounds = &to;
    triangles.clear();
    is_never_cut = true;
    standing.clear();
}

void Summary::turn_to(const Around& tile, std::span<const std::uint32_t> near,
                      std::span<const ViewBounds* const> renderers) {
    tile_ = tile;
    widest_px_ = 0;
    all_cover_ = true;
    is_sorted_out_ = false;
    pixel_ = 0;
    untrusted_.clear();
    renderers_.resize(renderers.size());
    for (std::size_t i = 0; i < renderers.size(); ++i) {
        renderers_[i].turn_to(*renderers[i]);
        widest_px_ = std::max(widest_px_, renderers[i]->background_eps_px());
    }
    meet(near);
    if (std::isfinite(widest_px_)) sort_out();
}

void Summary::meet(std::span<const std::uint32_t> near) {
    present_.clear();
    shared_.acquaintance.expect(near);
    for (const std::uint32_t t : near) {
        const KnownTriangle& known = shared_.acquaintance.of(t);
        for (Renderer& r : renderers_) {
            const BoundedTriangle& bounded = shared_.acquaintance.of(t, *r.bounds);
            r.triangles.emplace_back(bounded, bounded.most_eps_px(known.filter, tile_));
            widest_px_ = std::max(widest_px_, r.triangles.back().most_eps_px);
            r.is_never_cut &= bounded.is_never_cut;
        }
        present_.push_back({t, &known, false});
    }
}

/// Keeps what does not certainly miss the tile.
void Summary::sort_out() {
    tile_.half_x += widest_px_;
    tile_.half_y += widest_px_;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < present_.size(); ++i) {
        const Place place = filter(i).place_of(tile_);
        if (place == Place::misses && filter(i).is_trusted) continue;
        if (!filter(i).is_trusted) untrusted_.push_back(kept);
        present_[kept] = present_[i];
        present_[kept].covers_tile = place == Place::covers;
        all_cover_ &= place == Place::covers;
        for (Renderer& r : renderers_) r.triangles[kept] = r.triangles[i];
        ++kept;
    }
    present_.resize(kept);
    for (Renderer& r : renderers_) {
        r.triangles.erase(r.triangles.begin() + std::ptrdiff_t(kept), r.triangles.end());
        r.standing.resize(kept);
    }
    places_.turn_to(widest_px_);
    for (std::size_t i = 0; i < kept; ++i)
        filter(i).is_trusted ? places_.add(filter(i), present_[i].covers_tile) : places_.add_unknown();
    if (all_cover_) places_.sort(0, 0, covering_, cutting_);
}

void Summary::sort_out_pixel() {
    if (is_sorted_out_) return;
    is_sorted_out_ = true;
    sight_ = shared_.sights.at(x_, y_);
    if (all_cover_) return;
    places_.sort(x_, y_, covering_, cutting_);
    if (!untrusted_.empty())
        std::erase_if(cutting_, [&](std::size_t i) { return filter(i).misses(square(widest_px_)); });
}

auto Summary::renderer_of(const ViewBounds* bounds) -> Renderer& {
    return *std::ranges::find(renderers_, bounds, &Renderer::bounds);
}

std::optional<std::size_t> Summary::index_of(PrimitiveId answer) const {
    const auto found = std::ranges::find(present_, std::uint32_t(answer), &Present::triangle);
    if (found == present_.end()) return std::nullopt;
    return std::size_t(found - present_.begin());
}

/// As neighbourhood_of has it; the answer's own is in it from the start. The image of a triangle that is not
/// trusted may say anything.
double Summary::eps_px(const Renderer& renderer, const Plaint& plaint,
                       std::optional<std::size_t> answer) const {
    double eps = plaint.own_eps_px;
    const auto may_be_larger = [&](std::size_t i) {
        return i != answer && !(renderer.triangles[i].most_eps_px <= eps);
    };
    for (const std::size_t i : covering_)
        if (may_be_larger(i)) eps = std::max(eps, renderer.triangles[i].triangle->of_view.eps_px(sight_));
    const auto count_in = [&](std::size_t i) {
        if (!may_be_larger(i)) return;
        const TriangleOfView& triangle = renderer.triangles[i].triangle->of_view;
        const double its_eps = triangle.eps_px(sight_);
        if (its_eps <= eps) return;
        const auto image = triangle.seen->image.at(sight_);
        if (image && comes_within(*image, plaint.own_eps_px) && filter(i).is_near(x_, y_, plaint.reach_px))
            eps = its_eps;
    };
    std::ranges::for_each(cutting_, count_in);
    std::ranges::for_each(untrusted_, count_in);
    return eps;
}

bool Summary::is_uncut(const Renderer& renderer) const {
    if (renderer.is_never_cut) return true;
    const auto is_uncut = [&](std::size_t i) {
        return renderer.triangles[i].triangle->is_uncut(filter(i), square(widest_px_));
    };
    return std::ranges::all_of(covering_, is_uncut) && std::ranges::all_of(cutting_, is_uncut);
}

/// All of the box, between near and far.
bool Summary::covers(const Renderer& renderer, std::size_t i, const Around& box) const {
    return filter(i).place_of(box) == Place::covers &&
           renderer.triangles[i].triangle->is_clear_of_planes(filter(i), box);
}

bool Summary::is_inside(std::size_t i, const PixelOffset& at) const {
    const TriangleFilter& f = filter(i);
    const auto is_inside_of = [&](std::size_t k) {
        return value_at(f.edge[k], x_, y_, at.x, at.y) > f.edge_error[k];
    };
    return f.is_trusted && is_inside_of(0) && is_inside_of(1) && is_inside_of(2);
}

bool Summary::is_outside(std::size_t i, const PixelOffset& at) const {
    const TriangleFilter& f = filter(i);
    if (!f.is_trusted) return f.misses(around_place(x_ + at.x, y_ + at.y));
    const auto is_outside_of = [&](std::size_t k) {
        return value_at(f.edge[k], x_, y_, at.x, at.y) < -f.edge_error[k];
    };
    return is_outside_of(0) || is_outside_of(1) || is_outside_of(2);
}

bool Summary::is_behind(std::size_t back, std::size_t front, const PixelOffset& at) const {
    const TriangleFilter &b = filter(back), &f = filter(front);
    if (!b.is_trusted) return false;
    return value_at(f.nearness - b.nearness, x_, y_, at.x, at.y) > f.nearness_error + b.nearness_error;
}

/// All but what lies behind it at every place of the widest square, certainly.
void Summary::find_rivals(std::optional<std::size_t> answer) {
    rivals_.clear();
    const Around widest = square(widest_px_);
    const auto is_behind_all_over = [&](std::size_t i) {
        return answer && filter(*answer).is_trusted && filter(i).is_trusted &&
               order_in(widest, filter(*answer), filter(i)) == 1;
    };
    for (const auto& some : {std::cref(covering_), std::cref(cutting_)})
        for (const std::size_t i : some.get())
            if (i != answer && !is_behind_all_over(i)) rivals_.push_back(i);
}

/// Nothing hides it there, whatever the rule: what is certainly outside or behind is in no hiding set.
bool Summary::is_seen_at(std::optional<std::size_t> answer, const PixelOffset& at) const {
    if (answer && !is_inside(*answer, at)) return false;
    return std::ranges::all_of(
        rivals_, [&](std::size_t i) { return is_outside(i, at) || (answer && is_behind(i, *answer, at)); });
}

/// The square's corners and the middles of its sides, and for a triangle the middle of its part of the
/// square.
template <class IsThere>
bool Summary::is_anywhere(std::optional<std::size_t> answer, double half_side_px,
                          const IsThere& is_there) const {
    const double h = half_side_px;
    for (const PixelOffset& at :
         {PixelOffset{-h, -h}, {h, -h}, {-h, h}, {h, h}, {-h, 0}, {h, 0}, {0, -h}, {0, h}})
        if (is_there(at)) return true;
    if (!answer) return false;
    const Part part = part_of(*answer, h);
    return !part.is_empty() && is_there(held_within(h, part.middle()));
}

bool Summary::is_seen_around(std::optional<std::size_t> answer, double half_side_px) const {
    return is_anywhere(answer, half_side_px, [&](const PixelOffset& at) { return is_seen_at(answer, at); });
}

/// Between the middle of its part of the square and that part's outline.
bool Summary::is_seen_in_part(std::size_t answer, double half_side_px) const {
    const Part part = part_of(answer, half_side_px);
    if (part.is_empty()) return false;
    const PixelOffset middle = part.middle();
    const auto is_seen_on_the_way = [&](const PixelOffset& to, double share) {
        return is_seen_at(answer, held_within(half_side_px, between(middle, to, share)));
    };
    const auto is_seen_towards = [&](const PixelOffset& at) {
        return is_seen_on_the_way(at, 0.9) || is_seen_on_the_way(at, 0.5);
    };
    for (std::size_t k = 0; k < part.count; ++k)
        if (is_seen_towards(part.corner[k]) ||
            is_seen_towards(between(part.corner[k], part.next_corner(k), 0.5)))
            return true;
    return false;
}

/// Where the estimate says that it is.
bool Summary::is_seen_where(std::size_t answer, double half_side_px, Estimate& estimate) const {
    return std::ranges::any_of(estimate.places_seen(half_side_px), [&](const PixelOffset& at) {
        return is_seen_at(answer, held_within(half_side_px, at));
    });
}

/// Is there a place that nothing hides by the bounded rule?
bool Summary::is_held_around(const Renderer& renderer, std::size_t answer, double half_side_px) const {
    const auto is_held_at = [&](const PixelOffset& at) {
        const auto leaves_free = [&](std::size_t i) {
            return i == answer || is_outside(i, at) || !may_be_hidden_for_certain(renderer, i, answer);
        };
        return is_inside(answer, at) && std::ranges::all_of(covering_, leaves_free) &&
               std::ranges::all_of(cutting_, leaves_free);
    };
    return is_anywhere(answer, half_side_px, is_held_at);
}

/// But for rounding: clipping, edge by edge.
auto Summary::part_of(std::size_t i, double half_side_px) const -> Part {
    const double h = half_side_px;
    Part part{{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}}, 4};
    for (const Affine<double>& e : filter(i).edge) {
        Part kept;
        const auto keep = [&](const PixelOffset& at) {
            if (kept.count < kept.corner.size()) kept.corner[kept.count++] = at;
        };
        const auto value = [&](const PixelOffset& at) { return value_at(e, x_, y_, at.x, at.y); };
        for (std::size_t k = 0; k < part.count; ++k) {
            const PixelOffset &p = part.corner[k], &q = part.next_corner(k);
            const double at_p = value(p), at_q = value(q), t = at_p / (at_p - at_q);
            if (at_p >= 0) keep(p);
            if ((at_p >= 0) != (at_q >= 0)) keep(between(p, q, t));
        }
        part = kept;
    }
    return part;
}

PixelOffset Summary::Part::middle() const {
    PixelOffset sum{0, 0};
    for (std::size_t k = 0; k < count; ++k) sum = {sum.x + corner[k].x, sum.y + corner[k].y};
    return {sum.x / double(count), sum.y / double(count)};
}

bool Summary::are_coplanar(std::size_t a, std::size_t b) const {
    const auto of_scene = [&](std::size_t i) {
        return CoplanarMemory::Triangle{present_[i].triangle, present_[i].known->seen.p_world};
    };
    return shared_.coplanar(of_scene(a), of_scene(b));
}

/// Does `front`, which covers the box, take all of `back` away there by the strict rule and by true
/// visibility?
bool Summary::hides(const Renderer& renderer, std::size_t front, std::size_t back, const Around& box) const {
    if (!filter(back).is_trusted) return false;
    if (order_in(box, filter(front), filter(back)) != 1 && !are_coplanar(front, back)) return false;
    return nearness_of(renderer, front).greatest >= nearness_of(renderer, back).least;
}

bool Summary::is_hidden_in(const Renderer& renderer, std::optional<std::size_t> answer,
                           double half_side_px) const {
    const Around box = square(half_side_px);
    if (answer && filter(*answer).misses(box)) return true;
    return std::ranges::any_of(rivals_, [&](std::size_t i) {
        return answer ? covers_all_of(renderer, i, *answer, box) && hides(renderer, i, *answer, box)
                      : covers(renderer, i, box);
    });
}

/// What another has of the box: all edges that may pass there are the other's, too.
bool Summary::covers_all_of(const Renderer& renderer, std::size_t i, std::size_t other,
                            const Around& box) const {
    if (!filter(i).is_trusted || !renderer.triangles[i].triangle->is_clear_of_planes(filter(i), box))
        return false;
    for (std::uint32_t edges = filter(i).edges_within(box); edges != 0; edges &= edges - 1)
        if (!shares_edge(i, std::size_t(std::countr_zero(edges)), other)) return false;
    return true;
}

/// Do both have that edge of the first, and lie on the same side of it?
bool Summary::shares_edge(std::size_t i, std::size_t edge, std::size_t other) const {
    const auto ends = [&](std::size_t of, std::size_t k) {
        const CornersWorld& p = present_[of].known->seen.p_world;
        return std::pair{p[(k + 1) % 3], p[(k + 2) % 3]};
    };
    if (!filter(other).is_trusted) return false;
    const auto [from, to] = ends(i, edge);
    const Affine<double>& e = filter(i).edge[edge];
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [start, end] = ends(other, k);
        if (!(from == start && to == end) && !(from == end && to == start)) continue;
        const Affine<double>& f = filter(other).edge[k];
        return e.a * f.a + e.b * f.b > 0;
    }
    return false;
}

const NearnessRange& Summary::nearness_of(const Renderer& renderer, std::size_t i) const {
    const Bounded& bounded = renderer.triangles[i];
    if (bounded.nearness.pixel != pixel_)
        bounded.nearness = {pixel_, nearness_range_of(sight_, bounded.triangle->of_view)};
    return bounded.nearness.range;
}

bool Summary::may_be_hidden_for_certain(const Renderer& renderer, std::size_t front, std::size_t back) const {
    return nearness_of(renderer, front).least > nearness_of(renderer, back).greatest;
}

/// Where all that is present covers the box, and all but the answer and `others` lies behind it: is some of
/// those not behind, and none in front for certain? Of two in one plane neither is.
template <class IsCertain>
bool Summary::is_tied(const Renderer& renderer, std::size_t answer, std::span<const std::size_t> others,
                      const Around& box, const IsCertain& may_be_certain) const {
    const auto is_clear = [&](std::size_t i) {
        return renderer.triangles[i].triangle->is_clear_of_planes(filter(i), box);
    };
    if (!is_clear(answer)) return false;
    bool is_tied = false;
    for (const std::size_t i : others) {
        if (i == answer) continue;
        const int order = order_in(box, filter(i), filter(answer));
        if (order < 0) continue;
        if (!is_clear(i)) return false;
        if (!are_coplanar(i, answer) && (order == 0 || may_be_certain(i))) return false;
        is_tied = true;
    }
    return is_tied;
}

std::optional<Standing> Summary::standing_in_tile(Renderer& renderer, std::size_t answer) {
    if (!all_cover_) return std::nullopt;
    std::optional<Standing>& known = renderer.standing[answer];
    const auto always = [](std::size_t) { return true; };
    if (!known)
        known = is_tied(renderer, answer, covering_, tile_, always) ? Standing::tied : Standing::outside;
    return known;
}

/// The half-side at which a corner of the square reaches the answer's triangle, and no other that holds the
/// centre and is not behind. Any number will do, but for what an estimate says that is not monotone.
double Summary::likely_displacement_px(std::optional<std::size_t> answer) const {
    const auto at_centre = [&](const Affine<double>& f) { return f.at(x_, y_); };
    const auto beyond = [&](const Affine<double>& e) {
        return at_centre(e) / (std::abs(e.a) + std::abs(e.b));
    };
    double likely_px = 0;
    if (answer)
        for (const Affine<double>& e : filter(*answer).edge) likely_px = std::max(likely_px, -beyond(e));
    for (const std::size_t i : rivals_) {
        const TriangleFilter& rival = filter(i);
        if (!rival.is_trusted) continue;
        if (answer && at_centre(rival.nearness) < at_centre(filter(*answer).nearness)) continue;
        likely_px = std::max(likely_px,
                             std::min({beyond(rival.edge[0]), beyond(rival.edge[1]), beyond(rival.edge[2])}));
    }
    return likely_px;
}

/// Below the likely half-side the answer is likely hidden: then that is asked first.
Ruled Summary::visible(const Renderer& renderer, const Plaint& plaint, std::optional<std::size_t> answer,
                       double eps, Estimate& estimate) const {
    Ruled ruled{{Standing::visible, false}, eps, std::nullopt};
    if (plaint.asked == Asked::standing) return ruled;
    const double likely_px = likely_displacement_px(answer);
    ruled.displacement_over_eps = least_step(eps, likely_px, [&](double half_side_px) {
        const auto is_hidden = [&] { return is_hidden_in(renderer, answer, half_side_px); };
        const bool is_likely_seen = half_side_px >= likely_px;
        if (!is_likely_seen && is_hidden()) return false;
        if (is_seen_around(answer, half_side_px)) return true;
        return !(is_likely_seen && is_hidden()) && estimate.is_seen_within(half_side_px);
    });
    return ruled;
}

double Summary::lacking_reach_px(const Plaint& plaint) {
    if (!std::isfinite(widest_px_) || plaint.own_eps_px > widest_px_) return 0;
    sort_out_pixel();
    const double eps = eps_px(renderer_of(plaint.bounds), plaint, index_of(plaint.answer));
    return eps > plaint.reach_px ? eps : 0;
}

std::optional<Ruled> Summary::rule(const Plaint& plaint, Estimate& estimate) {
    if (!std::isfinite(widest_px_) || plaint.own_eps_px > widest_px_) return std::nullopt;
    Renderer& renderer = renderer_of(plaint.bounds);
    sort_out_pixel();
    const bool is_background = plaint.answer == PrimitiveId::none;
    const std::optional<std::size_t> answer = is_background ? std::nullopt : index_of(plaint.answer);
    if (!is_background && !answer) return std::nullopt;
    if (!is_uncut(renderer)) return std::nullopt;
    const double eps = eps_px(renderer, plaint, answer);
    if (eps > plaint.reach_px) return std::nullopt;
    if (answer && standing_in_tile(renderer, *answer) == Standing::tied)
        return Ruled{{Standing::tied, false}, eps, std::nullopt};
    find_rivals(answer);
    if (is_seen_at(answer, {0, 0})) return Ruled{{Standing::visible, false}, eps, std::nullopt};
    const auto may_be_certain = [&](std::size_t i) {
        return may_be_hidden_for_certain(renderer, i, *answer);
    };
    const bool all_cover = answer && cutting_.empty() && std::ranges::count(covering_, *answer) != 0;
    if (all_cover && is_tied(renderer, *answer, rivals_, square(widest_px_), may_be_certain))
        return Ruled{{Standing::tied, false}, eps, std::nullopt};
    if (answer && is_hidden_in(renderer, answer, eps)) {
        if (!is_held_around(renderer, *answer, plaint.own_eps_px)) return std::nullopt;
        return Ruled{{Standing::tied, false}, eps, std::nullopt};
    }
    // on an edge: what is seen that close is seen in every larger square, and needs no displacement
    const double close = least_px(eps);
    const bool misses = answer && filter(*answer).misses(square(close));
    if (!misses && close <= plaint.own_eps_px && is_seen_around(answer, close))
        return Ruled{{Standing::visible, false}, eps, std::nullopt};
    if (is_seen_around(answer, plaint.own_eps_px) || (eps > plaint.own_eps_px && is_seen_around(answer, eps)))
        return visible(renderer, plaint, answer, eps, estimate);
    if (answer && (is_seen_in_part(*answer, eps) || is_seen_where(*answer, eps, estimate)))
        return visible(renderer, plaint, answer, eps, estimate);
    return std::nullopt;
}

}  // namespace zproof
