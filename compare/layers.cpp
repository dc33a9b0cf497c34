#include "compare/layers.h"

#include <algorithm>
#include <cmath>

#include "compare/coplanar.h"
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

Layers::Layers(const Shared& shared, const Around& centres, std::span<const std::uint32_t> near,
               std::span<const ViewBounds* const> renderers)
    : shared_(shared), tile_(centres), left_(int(centres.x - centres.half_x)) {
    for (const ViewBounds* bounds : renderers) {
        renderers_.push_back({.bounds = bounds, .triangles = {}, .nearness = {}, .close = {}});
        widest_px_ = std::max(widest_px_, bounds->background_eps_px());
    }
    meet(near);
    are_known_ = are_known_ && std::isfinite(widest_px_);
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
        layers_[kept] = layers_[i];
        layers_[kept].cutting = place == TriangleFilter::Place::covers ? 0 : filter.edges_within(tile_);
        for (Renderer& r : renderers_) r.triangles[kept] = r.triangles[i];
        ++kept;
    }
    layers_.resize(kept);
    are_known_ = are_known_ && kept <= most;
    if (!are_known_) return;
    for (Renderer& r : renderers_)
        for (std::size_t i = 0; i < kept; ++i)
            r.clear |= Set(r.triangles[i]->is_clear_of_planes(layers_[i].known->filter, tile_)) << i;
}

void Layers::place(int y) {
    row_ = {left_, y};
    cut_ = 0;
    for (Layer& layer : layers_) {
        const PlaceMasks places = places_in_row(layer.known->filter, layer.cutting, row_, widest_px_);
        layer.covers = places.covers;
        cut_ |= places.cuts;
    }
}

ColumnMask Layers::turn_to(int y, ColumnMask pixels) {
    place(y);
    asked_ = pixels & ~cut_;
    if (asked_ == 0) return 0;
    sight_.reset();
    for (Layer& layer : layers_) layer.row.reset();
    for (Renderer& r : renderers_) {
        r.unclear = 0;
        for (std::size_t i = 0; i < layers_.size(); ++i)
            if ((r.clear >> i & 1) == 0) r.unclear |= layers_[i].covers;
        r.known = 0;
    }
    return asked_;
}

const TriangleRow& Layers::row_of(std::size_t layer) {
    std::optional<TriangleRow>& row = layers_[layer].row;
    if (!sight_) sight_.emplace(shared_.sights, row_);
    if (!row) row.emplace(layers_[layer].known->seen.image, *sight_);
    return *row;
}

TileRow Layers::eps_px(std::size_t renderer) {
    TileRow eps_px{};
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        if ((layers_[i].covers & asked_) == 0) continue;
        const TileRow of_layer = row_of(i).eps_px(renderers_[renderer].triangles[i]->of_view);
        eps_px = raised(eps_px, of_layer, layers_[i].covers);
    }
    return eps_px;
}

std::optional<std::size_t> Layers::index_of(std::uint32_t triangle) const {
    const auto found = std::ranges::find(layers_, triangle, &Layer::triangle);
    if (found == layers_.end()) return std::nullopt;
    return std::size_t(found - layers_.begin());
}

auto Layers::relations_of(std::size_t layer) -> const Relations& {
    Layer& one = layers_[layer];
    if (one.others) return *one.others;
    one.others = Relations{};
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (i == layer) continue;
        const KnownTriangle& other = *layers_[i].known;
        const int order = order_in(tile_, other.filter, one.known->filter);
        const auto are_coplanar = [&] {  // asked one way round: of triangles that are seen it is the same
            const std::size_t a = std::min(i, layer), b = std::max(i, layer);
            const std::uint64_t pair = std::uint64_t{layers_[a].triangle} << 32 | layers_[b].triangle;
            return shared_.coplanar(pair, [&] {
                return coplanar(layers_[a].known->seen.p_world, layers_[b].known->seen.p_world);
            });
        };
        if (order < 0)
            one.others->behind |= Set{1} << i;
        else if (order > 0)
            one.others->ahead |= Set{1} << i;
        else if (are_coplanar())
            one.others->level |= Set{1} << i;
    }
    return *one.others;
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

auto Layers::close_to(Renderer& renderer, std::size_t back) -> Set {
    renderer.close.resize(layers_.size());
    std::optional<Set>& close = renderer.close[back];
    if (close) return *close;
    close = 0;
    for (std::size_t front = 0; front < layers_.size(); ++front)
        *close |= Set{is_close(renderer, front, back)} << front;
    return *close;
}

const TriangleRow::Range& Layers::nearness(Renderer& renderer, std::size_t layer) {
    renderer.nearness.resize(layers_.size());
    if ((renderer.known >> layer & 1) == 0)
        renderer.nearness[layer] = row_of(layer).nearness_range(renderer.triangles[layer]->of_view);
    renderer.known |= Set{1} << layer;
    return renderer.nearness[layer];
}

ColumnMask Layers::ahead_for_certain(Renderer& renderer, std::size_t front, std::size_t back) {
    return above(nearness(renderer, front).least, nearness(renderer, back).greatest);
}

/// Of two in one plane neither is in front for certain, and what is behind is not (docs/truth.md, "Layers").
auto Layers::standings(std::size_t of, std::uint32_t triangle, ColumnMask pixels) -> Standings {
    const std::optional<std::size_t> answer = index_of(triangle);
    if (!answer) return {};
    Renderer& renderer = renderers_[of];
    const ColumnMask covered = pixels & layers_[*answer].covers & ~cut_ & ~renderer.unclear;
    if (covered == 0) return {};
    const Relations& others = relations_of(*answer);
    ColumnMask rivals = 0, undecided = 0;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        ColumnMask shared = layers_[i].covers & covered;
        const Set bit = Set{1} << i;
        if (shared == 0 || i == *answer || (others.behind & bit) != 0) continue;
        ColumnMask ahead = (others.ahead & bit) != 0 ? shared : 0;
        if ((others.crossing() & bit) != 0) {
            const OrderMasks order =
                orders_in_row(layers_[i].known->filter, layers_[*answer].known->filter, row_, widest_px_);
            shared &= ~order.behind;
            ahead = shared & order.ahead;
            undecided |= shared & ~ahead;
        }
        rivals |= shared;
        if (ahead != 0 && (close_to(renderer, *answer) & bit) == 0)
            undecided |= ahead & ahead_for_certain(renderer, i, *answer);
    }
    return {.tied = rivals & ~undecided, .visible = covered & ~rivals};
}

}  // namespace zproof
