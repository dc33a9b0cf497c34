#include "compare/adjudicate/tile_work.h"

#include <algorithm>

#include "compare/admissible/displacement.h"

namespace zproof {

namespace {

/// In own eps: few squares grow beyond it, and a triangle that is found and meets no square changes nothing.
constexpr double first_reach = 2;

/// Pairs of a tile that are remembered.
constexpr std::size_t coplanar_pairs = 256;

}  // namespace

std::optional<std::size_t> TriangleCache::place_of(PrimitiveId triangle) const {
    const auto found = std::ranges::lower_bound(near_, std::uint32_t(triangle));
    if (found == near_.end() || *found != std::uint32_t(triangle)) return std::nullopt;
    return std::size_t(found - near_.begin());
}

const BoundedTriangle& TriangleCache::of(std::size_t place, const ViewBounds& bounds) {
    auto found = std::ranges::find(renderers_, &bounds, &OfRenderer::bounds);
    if (found == renderers_.end())
        found = renderers_.insert(renderers_.end(),
                                  {&bounds, std::vector<std::optional<BoundedTriangle>>(near_.size())});
    std::optional<BoundedTriangle>& triangle = found->triangles[place];
    if (!triangle) triangle.emplace(bounds, corners_of(scene_, near_[place]));
    return *triangle;
}

TileWork::TileWork(const Setting& setting, std::span<const std::uint32_t> near)
    : setting_(setting), triangles_(setting.scene, near), coplanar_(coplanar_pairs) {
    boxes_.reserve(near.size());
    for (const std::uint32_t triangle : near) boxes_.push_back(setting.search.box_of(triangle));
}

double TileWork::own_eps_px(const PixelQuery& query) {
    if (query.answer == PrimitiveId::none) return query.bounds->background_eps_px();
    const auto place = triangles_.place_of(query.answer);
    const auto ray = setting_.rays.at(query.x, query.y);
    return place ? neighbour_of(ray, triangles_.of(*place, *query.bounds)).bounds.eps_px
                 : neighbour_of(ray, *query.bounds, corners_of(setting_.scene, std::uint32_t(query.answer)))
                       .bounds.eps_px;
}

/// What stands around the pixel, as far as that reach.
Neighbourhood TileWork::gather(const PixelQuery& query, double own_eps_px, double reach_px) {
    const Sight<double> ray = setting_.rays.at(query.x, query.y);
    const Box square = square_around(query.x, query.y, reach_px);
    Neighbourhood around{setting_.view, query.x, query.y, own_eps_px, {}};
    for (std::size_t place = 0; place < triangles_.count(); ++place) {
        if (!boxes_[place].meets(square)) continue;
        Neighbour neighbour = neighbour_of(ray, triangles_.of(place, *query.bounds));
        neighbour.triangle = triangles_.triangle(place);
        add(around, std::move(neighbour), own_eps_px);
    }
    if (setting_.override) setting_.override(around, query.answer);
    return around;
}

double TileWork::decide(const PixelQuery& query, double searched_px, Adjudicated& adjudicated) {
    const double own_eps = own_eps_px(query);
    double reach_px = first_reach * own_eps;
    while (reach_px <= searched_px) {
        const Neighbourhood around = gather(query, own_eps, reach_px);
        if (around.eps_px > reach_px) {
            reach_px = around.eps_px;
            continue;
        }
        adjudicated = {zproof::decide(around, query.answer, coplanar_), std::nullopt};
        if (setting_.asked == Asked::displacement &&
            adjudicated.decision.admissibility == Admissibility::visible)
            adjudicated.displacement_over_eps = displacement_over_eps(around, query.answer, coplanar_);
        return 0;
    }
    return reach_px;
}

}  // namespace zproof
