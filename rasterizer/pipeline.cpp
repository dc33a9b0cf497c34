#include "rasterizer/pipeline.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <optional>

#include "rasterizer/tile.h"
#include "rasterizer/tile_bins.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {

Frame render_by(const Rules& rules, const Scene& scene, const View& view) {
    const ViewSetup setup(view, rules);
    Frame frame;
    std::optional<TileBins> bins;
    tbb::parallel_invoke([&] { frame = Frame(setup.size); },  // 8 bytes a pixel to be filled: worth a thread
                         [&] { bins.emplace(scene, project(scene.vertices, setup), setup); });
    tbb::parallel_for(std::size_t{0}, bins->tiles().count(), [&](std::size_t i) {
        const auto triangles = bins->in_tile(i);
        if (triangles.empty()) return;
        Tile tile(bins->tiles().pixels(i, setup.size), setup);
        for (const SnappedTriangle* triangle : triangles) tile.draw(*triangle);
        tile.resolve(frame);
    });
    return frame;
}

}  // namespace zproof::rasterizer
