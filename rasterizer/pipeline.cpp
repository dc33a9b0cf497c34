#include "rasterizer/pipeline.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <optional>

#include "rasterizer/tile.h"
#include "rasterizer/tile_bins.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {
namespace {

/// work(tile, triangles) of each tile that has triangles, in parallel.
template <class Work>
void for_each_tile(const TileBins& bins, const ViewSetup& setup, Work work) {
    tbb::parallel_for(std::size_t{0}, bins.tiles().count(), [&](std::size_t i) {
        const auto triangles = bins.in_tile(i);
        if (triangles.empty()) return;
        Tile tile(bins.tiles().pixels(i, setup.size), setup);
        work(tile, triangles);
    });
}

}  // namespace

Frame render_by(const Rules& rules, const Scene& scene, const View& view) {
    const ViewSetup setup(view, rules);
    Frame frame;
    std::optional<TileBins> bins;
    tbb::parallel_invoke([&] { frame = Frame(setup.size); },  // 8 bytes a pixel to be filled: worth a thread
                         [&] { bins.emplace(scene, project(scene.vertices, setup), setup); });
    for_each_tile(*bins, setup, [&](Tile& tile, const auto& triangles) {
        for (const SnappedTriangle* triangle : triangles) tile.draw(*triangle);
        tile.resolve(frame);
    });
    return frame;
}

Plane<std::uint32_t> count_fragments(const Rules& rules, const Scene& scene, const View& view) {
    const ViewSetup setup(view, rules);
    Plane<std::uint32_t> fragments(setup.size);
    const TileBins bins(scene, project(scene.vertices, setup), setup);
    for_each_tile(bins, setup, [&](const Tile& tile, const auto& triangles) {
        for (const SnappedTriangle* triangle : triangles) tile.count(*triangle, fragments);
    });
    return fragments;
}

}  // namespace zproof::rasterizer
