#include "compare/layers/layers.h"

#include <algorithm>
#include <cmath>

#include "compare/layers/squares_of_tile.h"
#include "math/rounding.h"

namespace zproof {

namespace {

/// Of an affine function over a box, but for rounding.
struct Extremes {
    double least, most;
};
Extremes extremes(const Affine<double>& f, const Around& box) {
    const double middle = f.at(box.x, box.y), most_off = reach(f, box);
    return {middle - most_off, middle + most_off};
}

}  // namespace

void Layers::Renderer::turn_to(const ViewBounds& to) {
    bounds = &to;
    triangles.clear();
    unclear = {};
    nearness.clear();
}

void Layers::turn_to(const TilePlace& tile, const Around& centres, std::span<const std::uint32_t> near,
                     std::span<const ViewBounds* const> renderers) {
    place_ = tile;
    tile_ = centres;
    widest_px_ = 0;
    layers_.clear();
    relations_.clear();
    sights_ = {};
    renderers_.resize(renderers.size());
    for (std::size_t i = 0; i < renderers.size(); ++i) {
        renderers_[i].turn_to(*renderers[i]);
        widest_px_ = std::max(widest_px_, renderers[i]->background_eps_px());
    }
    meet(near);
    are_known_ = std::isfinite(widest_px_);
    if (are_known_) sort_out();
}

void Layers::meet(std::span<const std::uint32_t> near) {
    for (const std::uint32_t t : near) {
        const KnownTriangle& known = shared_.acquaintance.of(t);
        layers_.push_back({.triangle = t, .known = &known});
        for (Renderer& r : renderers_) {
            r.triangles.push_back(&shared_.acquaintance.of(t, *r.bounds));
            widest_px_ = std::max(widest_px_, r.triangles.back()->most_eps_px(known.filter, tile_));
        }
    }
}

/// Keeps what does not certainly miss the tile.
void Layers::sort_out() {
    tile_.half_x += widest_px_;
    tile_.half_y += widest_px_;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const TriangleFilter& filter = layers_[i].known->filter;
        const TriangleFilter::Place place = filter.place_of(tile_);
        if (place == TriangleFilter::Place::misses && filter.is_trusted) continue;
        are_known_ = are_known_ && filter.is_trusted;
        if (kept != i) layers_[kept] = std::move(layers_[i]);
        layers_[kept].cutting = place == TriangleFilter::Place::covers ? 0 : filter.edges_within(tile_);
        for (Renderer& r : renderers_) r.triangles[kept] = r.triangles[i];
        ++kept;
    }
    layers_.resize(kept);
    are_known_ = are_known_ && kept <= most;
}

TileMask Layers::uncut(const TileMask& pixels) {
    TileMask cut;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        Layer& layer = layers_[i];
        const PlaceMasks places = places_of_squares(layer.known->filter, layer.cutting, place_, widest_px_);
        layer.covers = places.covers;
        cut |= places.cuts;
        for (Renderer& r : renderers_)
            if (!r.triangles[i]->is_clear_of_planes(layer.known->filter, tile_)) r.unclear |= places.covers;
    }
    return pixels & ~cut;
}

const TriangleRow& Layers::row_of(std::size_t layer, int y) {
    return layers_[layer].rows(y, [&] {
        const SightRow& sight = sights_(y, [&] { return SightRow(shared_.sights, place_.row(y)); });
        return TriangleRow(layers_[layer].known->seen.image, sight);
    });
}

TileRow Layers::eps_px(std::size_t renderer, int y) {
    TileRow eps_px{};
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const ColumnMask covered = layers_[i].covers.row(y);
        if (covered == 0) continue;
        const TileRow of_layer = row_of(i, y).eps_px(renderers_[renderer].triangles[i]->of_view);
        eps_px = raised(eps_px, of_layer, covered);
    }
    return eps_px;
}

std::optional<std::size_t> Layers::index_of(std::uint32_t triangle) const {
    const auto found = std::ranges::find(layers_, triangle, &Layer::triangle);
    if (found == layers_.end()) return std::nullopt;
    return std::size_t(found - layers_.begin());
}

auto Layers::relation(std::size_t other, std::size_t answer) -> Relation {
    relations_.resize(layers_.size() * layers_.size(), Relation::not_asked);
    Relation& known = relations_[answer * layers_.size() + other];
    if (known != Relation::not_asked) return known;
    const int order = order_in(tile_, layers_[other].known->filter, layers_[answer].known->filter);
    known = order < 0                     ? Relation::behind
            : order > 0                   ? Relation::ahead
            : are_coplanar(other, answer) ? Relation::level
                                          : Relation::crossing;
    return known;
}

/// Asked one way round: of triangles that are seen it is the same.
bool Layers::are_coplanar(std::size_t one, std::size_t other) {
    const auto of_scene = [&](std::size_t i) {
        return CoplanarMemory::Triangle{layers_[i].triangle, layers_[i].known->seen.p_world};
    };
    return shared_.coplanar(of_scene(std::min(one, other)), of_scene(std::max(one, other)));
}

/// Is it clear all over the tile that `front` is nowhere in front of `back` for certain? Either range of
/// nearness reaches at least as far as the renderer's relative error of depth.
bool Layers::is_close(const Renderer& renderer, std::size_t front, std::size_t back) const {
    const TriangleFilter &f = layers_[front].known->filter, &b = layers_[back].known->filter;
    const TriangleOfView &of_front = renderer.triangles[front]->of_view,
                         &of_back = renderer.triangles[back]->of_view;
    if (!of_front.on_plane || !of_back.on_plane) return false;
    static const double rounding = gamma(64, unit_roundoff_float64);
    const Extremes front_nearness = extremes(f.nearness, tile_), back_nearness = extremes(b.nearness, tile_);
    const double error = f.nearness_error + b.nearness_error;
    const double ahead = extremes(f.nearness - b.nearness, tile_).most + 2 * error +
                         rounding * (front_nearness.most + back_nearness.most);
    const double front_reach = (front_nearness.least - error) * of_front.bounds.depth_factor,
                 back_reach = (back_nearness.least - error) * of_back.bounds.depth_factor;
    return front_reach >= 0 && back_reach >= 0 && ahead <= front_reach + back_reach;
}

const TriangleRow::Range& Layers::nearness(Renderer& renderer, std::size_t layer, int y) {
    renderer.nearness.resize(layers_.size());
    return renderer.nearness[layer](
        y, [&] { return row_of(layer, y).nearness_range(renderer.triangles[layer]->of_view); });
}

TileMask Layers::ahead_for_certain(Renderer& renderer, std::size_t front, std::size_t back,
                                   const TileMask& pixels) {
    TileMask ahead;
    for_each_row(pixels, [&](int y, ColumnMask columns) {
        ahead.add(y,
                  columns & above(nearness(renderer, front, y).least, nearness(renderer, back, y).greatest));
    });
    return ahead;
}

/// Of two in one plane neither is in front for certain, and what is behind is not (docs/truth.md, "Layers").
auto Layers::standings(std::size_t of, std::uint32_t triangle, const TileMask& pixels) -> Standings {
    const std::optional<std::size_t> answer = index_of(triangle);
    if (!answer) return {};
    Renderer& renderer = renderers_[of];
    const TileMask covered = pixels & layers_[*answer].covers & ~renderer.unclear;
    if (covered.is_none()) return {};
    TileMask rivals, undecided;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        TileMask shared = layers_[i].covers & covered;
        if (i == *answer || shared.is_none()) continue;
        const Relation is = relation(i, *answer);
        if (is == Relation::behind) continue;
        TileMask ahead = is == Relation::ahead ? shared : TileMask{};
        if (is == Relation::crossing) {
            const OrderMasks order = orders_in_squares(layers_[i].known->filter,
                                                       layers_[*answer].known->filter, place_, widest_px_);
            shared &= ~order.behind;
            ahead = shared & order.ahead;
            undecided |= shared & ~ahead;
        }
        rivals |= shared;
        if (!ahead.is_none() && !is_close(renderer, i, *answer))
            undecided |= ahead_for_certain(renderer, i, *answer, ahead);
    }
    return {.tied = rivals & ~undecided, .visible = covered & ~rivals};
}

}  // namespace zproof
