#include "rasterizer/pipeline.h"

#include <tbb/parallel_for.h>

#include "rasterizer/tile.h"
#include "rasterizer/tile_bins.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {

Frame render_by(const Rules& rules, const Scene& scene, const View& view) {
    const ViewSetup setup(view, rules);
    const ProjectedVertices projected = project(scene.vertices, setup);
    const TileBins bins(scene, projected, setup);
    Frame frame(setup.size);
    tbb::parallel_for(std::size_t{0}, bins.tiles().count(), [&](std::size_t i) {
        const auto triangles = bins.in_tile(i);
        if (triangles.empty()) return;
        Tile tile(bins.tiles().pixels(i, setup.size), setup);
        for (const SnappedTriangle* triangle : triangles) tile.draw(*triangle);
        tile.resolve(frame);
    });
    return frame;
}

}  // namespace zproof::rasterizer
