#include "compare/adjudicate/tile_work.h"

#include <algorithm>

#include "compare/admissible/displacement.h"

namespace zproof {

namespace {

/// In own eps: few squares grow beyond it, and a triangle that is found and meets no square changes nothing.
constexpr double first_reach = 2;

/// Pairs of a tile that are remembered.
constexpr std::size_t coplanar_pairs = 256;

/// Half the side of the least square around the pixel's centre that meets the box.
double distance_px_from(const Box& box, int x, int y) {
    const double px = x + 0.5, py = y + 0.5;
    return std::max({box.left - px, px - box.right, box.top - py, py - box.bottom, 0.0});
}

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
    : setting_(setting), triangles_(setting.scene, near), coplanar_(coplanar_pairs), around_{.view = setting.view, .neighbours = {}} {
    boxes_.reserve(near.size());
    for (const std::uint32_t triangle : near) boxes_.push_back(setting.search.box_of(triangle));
}

/// What comes within that reach of the pixel's centre.
void TileWork::gather(const PixelQuery& query, double reach_px) {
    const Sight<double> ray = setting_.rays.at(query.x, query.y);
    around_.x = query.x;
    around_.y = query.y;
    around_.neighbours.clear();
    distances_px_.clear();
    for (std::size_t place = 0; place < triangles_.count(); ++place) {
        const double distance_px = distance_px_from(boxes_[place], query.x, query.y);
        if (distance_px > reach_px) continue;
        around_.neighbours.push_back(neighbour_of(ray, triangles_.of(place, *query.bounds)));
        around_.neighbours.back().triangle = triangles_.triangle(place);
        distances_px_.push_back(distance_px);
    }
}

/// Of an answer that is among what was gathered, or not.
double TileWork::own_eps_px(const PixelQuery& query) const {
    const auto index = around_.index_of(query.answer);
    return index ? around_.neighbours[*index].bounds.eps_px
                 : zproof::own_eps_px(setting_.scene, setting_.view, *query.bounds, {query.x, query.y}, query.answer);
}

/// The largest eps, and own_eps_px at least, of what comes within own_eps_px of the centre and whose box is no farther
/// from it than reach_px.
double TileWork::eps_px_within(double reach_px, double own_eps_px) const {
    double eps_px = own_eps_px;
    for (std::size_t i = 0; i < distances_px_.size(); ++i) {
        const Neighbour& n = around_.neighbours[i];
        const bool is_near = distances_px_[i] <= reach_px && n.image && comes_within(*n.image, own_eps_px);
        if (is_near) eps_px = std::max(eps_px, n.bounds.eps_px);
    }
    return eps_px;
}

void TileWork::drop_beyond(double reach_px) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < distances_px_.size(); ++i) {
        if (distances_px_[i] > reach_px) continue;
        if (kept != i) around_.neighbours[kept] = around_.neighbours[i];
        ++kept;
    }
    around_.neighbours.resize(kept);
}

double TileWork::decide(const PixelQuery& query, double searched_px, Adjudicated& adjudicated) {
    gather(query, searched_px);
    const double own_eps = own_eps_px(query);
    double reach_px = first_reach * own_eps;
    around_.eps_px = eps_px_within(reach_px, own_eps);
    if (around_.eps_px > reach_px) reach_px = around_.eps_px;
    if (reach_px > searched_px) return reach_px;
    drop_beyond(reach_px);
    if (setting_.override) setting_.override(around_, query.answer);
    adjudicated = {zproof::decide(around_, query.answer, coplanar_), std::nullopt};
    if (setting_.asked == Asked::displacement && adjudicated.decision.admissibility == Admissibility::visible)
        adjudicated.displacement_over_eps = displacement_over_eps(around_, query.answer, coplanar_);
    return 0;
}

}  // namespace zproof
