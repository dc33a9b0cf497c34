#include "compare/adjudicate/triangle_search.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <array>
#include <cmath>

namespace zproof {

namespace {

/// Triangles that are searched together.
std::size_t chunk_triangles(std::size_t count) { return std::clamp<std::size_t>(count / 64, 64, 32768); }

/// A float is off by less than 2^-24 of what it stands for, and by less than 2^-126 where that is nearly 0.
float rounded_down(double a) { return float(std::max(a - std::abs(a) * 0x1p-23 - 0x1p-126, -0x1p126)); }
float rounded_up(double a) { return float(std::min(a + std::abs(a) * 0x1p-23 + 0x1p-126, 0x1p126)); }

int clamped(double px, int count) { return int(std::clamp(px / Tiles::side_px, 0.0, count - 1.0)); }

/// The farthest that any tile asks beyond its own pixels' centres.
double reach_of(const Tiles& tiles, std::span<const Box> asked) {
    double reach_px = 0;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            const Box& box = asked[tiles.index(column, row)];
            if (box.is_empty()) continue;
            const double left = column * Tiles::side_px, top = row * Tiles::side_px;
            reach_px = std::max({reach_px, left - box.left, top - box.top, box.right - left - Tiles::side_px,
                                 box.bottom - top - Tiles::side_px});
        }
    return reach_px;
}

}  // namespace

TriangleSearch::TriangleSearch(const Scene& scene, const View& view, Renderers renderers)
    : scene_(scene), projection_(view), tiles_(view), vertices_(scene.vertices.position_world.size()) {
    constexpr std::size_t together = 4096;
    tbb::parallel_for(std::size_t(0), (vertices_.size() + together - 1) / together, [&](std::size_t some) {
        const std::size_t end = std::min((some + 1) * together, vertices_.size());
        for (std::size_t i = some * together; i < end; ++i) {
            const Box box = projection_(scene.vertices.position_world[i]);
            vertices_[i] = box.is_empty() ? VertexBox{-HUGE_VALF, -HUGE_VALF, HUGE_VALF, HUGE_VALF}
                                          : VertexBox{rounded_down(box.left), rounded_down(box.top),
                                                      rounded_up(box.right), rounded_up(box.bottom)};
        }
    });
    find_near_triangles(view, renderers);
}

void TriangleSearch::find_near_triangles(const View& view, Renderers renderers) {
    const auto boxes_of_near = [&](const CornersWorld& p_world) {
        const Box before_eye = projection_.before_eye(p_world);
        if (before_eye.is_empty()) return ImageBoxes{};
        const Box beyond_half_near = projection_(p_world);
        for (const ViewBounds* bounds : renderers)
            if (!(bounds->of(p_world).near_slack < view.camera.near_depth / 2))
                return ImageBoxes{before_eye, beyond_half_near};
        return ImageBoxes{beyond_half_near, beyond_half_near};
    };
    const auto has_place = [&](std::uint32_t vertex) { return !std::isinf(vertices_[vertex].left); };
    tbb::enumerable_thread_specific<std::vector<NearTriangle>> found;
    tbb::parallel_for(std::size_t(0), scene_.triangles.size(), [&](std::size_t i) {
        const glm::uvec3& t = scene_.triangles[i];
        if (has_place(t.x) && has_place(t.y) && has_place(t.z)) return;
        const CornersWorld p_world = corners_of(scene_, std::uint32_t(i));
        const ImageBoxes boxes = boxes_of_near(p_world);
        if (!boxes.all.is_empty()) found.local().push_back({std::uint32_t(i), boxes});
    });
    for (const auto& some : found) near_.insert(near_.end(), some.begin(), some.end());
    tbb::parallel_sort(near_,
                       [](const NearTriangle& a, const NearTriangle& b) { return a.triangle < b.triangle; });
}

Box TriangleSearch::box_of_vertex(std::uint32_t vertex) const {
    const VertexBox& v = vertices_[vertex];
    return {v.left, v.top, v.right, v.bottom};
}

/// The hull of a triangle's corners; nothing where a corner has no place.
std::optional<CornerHull> TriangleSearch::hull_of(std::uint32_t triangle) const {
    const glm::uvec3& t = scene_.triangles[triangle];
    const std::array<Box, 3> corners{box_of_vertex(t.x), box_of_vertex(t.y), box_of_vertex(t.z)};
    if (std::ranges::any_of(corners, [](const Box& b) { return std::isinf(b.left); })) return std::nullopt;
    return CornerHull(corners);
}

ImageBoxes TriangleSearch::boxes_of(std::uint32_t triangle) const {
    const glm::uvec3& t = scene_.triangles[triangle];
    Box box = box_of_vertex(t.x);
    box.add(box_of_vertex(t.y));
    box.add(box_of_vertex(t.z));
    if (std::isfinite(box.left)) return {box, box};
    const auto near = std::ranges::lower_bound(near_, triangle, {}, &NearTriangle::triangle);
    return near != near_.end() && near->triangle == triangle ? near->boxes : ImageBoxes{};
}

/// Its sides are asked only where its box does not say no, and where it may lie in several tiles.
template <class Visit>
void TriangleSearch::for_each_tile_met(std::uint32_t triangle, std::span<const Box> asked, double reach_px,
                                       const Visit& visit) const {
    const Box box = box_of(triangle);
    if (box.is_empty()) return;
    const int left = clamped(box.left - reach_px, tiles_.columns),
              right = clamped(box.right + reach_px, tiles_.columns);
    const int top = clamped(box.top - reach_px, tiles_.rows),
              bottom = clamped(box.bottom + reach_px, tiles_.rows);
    const bool is_large = right - left > 1 || bottom - top > 1;
    const std::optional<CornerHull> hull = is_large ? hull_of(triangle) : std::nullopt;
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            const std::size_t tile = tiles_.index(column, row);
            if (box.meets(asked[tile]) && !(hull && hull->is_beside(asked[tile]))) visit(tile);
        }
}

TrianglesByTile TriangleSearch::find(std::span<const Box> asked) const {
    const double reach_px = reach_of(tiles_, asked);
    const std::size_t count = scene_.triangles.size(), length = chunk_triangles(count);
    std::vector<Bulk<TileTriangle>> chunks((count + length - 1) / length);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * length);
        for (std::size_t t = chunk * length; t < end; ++t)
            for_each_tile_met(std::uint32_t(t), asked, reach_px, [&](std::size_t tile) {
                chunks[chunk].push_back({std::uint32_t(tile), std::uint32_t(t)});
            });
    });
    // counted two places ahead, so that filling leaves each tile's end where the next one's first belongs
    TrianglesByTile found{std::vector<std::size_t>(tiles_.count() + 2), {}};
    for (const auto& chunk : chunks)
        for (const TileTriangle& m : chunk) ++found.first[m.tile + 2];
    for (std::size_t t = 2; t < found.first.size(); ++t) found.first[t] += found.first[t - 1];
    found.triangles.resize(found.first.back());
    for (const auto& chunk : chunks)
        for (const TileTriangle& m : chunk) found.triangles[found.first[m.tile + 1]++] = m.triangle;
    found.first.pop_back();
    return found;
}

void find_nearby_triangles(const Scene& scene, const View& view, Renderers renderers,
                           std::span<SearchPixel> search_pixels) {
    const TriangleSearch search(scene, view, renderers);
    const Tiles tiles(view);
    std::vector<Box> asked(tiles.count());
    for (const SearchPixel& search_pixel : search_pixels)
        asked[tiles.of(search_pixel.x, search_pixel.y)].add(
            square_around(search_pixel.x, search_pixel.y, search_pixel.reach_px));
    const TrianglesByTile near = search.find(asked);
    tbb::parallel_for(std::size_t(0), search_pixels.size(), [&](std::size_t i) {
        SearchPixel& search_pixel = search_pixels[i];
        search_pixel.triangles.clear();
        const Box square = square_around(search_pixel.x, search_pixel.y, search_pixel.reach_px);
        for (const std::uint32_t t : near.of(tiles.of(search_pixel.x, search_pixel.y)))
            if (search.box_of(t).meets(square)) search_pixel.triangles.push_back(t);
    });
}

}  // namespace zproof
