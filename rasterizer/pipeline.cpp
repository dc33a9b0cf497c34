#include "rasterizer/pipeline.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>

#include "rasterizer/tile.h"

namespace zproof::rasterizer {
namespace {

void clear(Frame& frame, const PixelRect& pixels) {
    const auto columns = std::size_t(pixels.x1 - pixels.x0);
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        std::ranges::fill(frame.primitive.row(y).subspan(std::size_t(pixels.x0), columns), PrimitiveId::none);
        std::ranges::fill(frame.camera_depth.row(y).subspan(std::size_t(pixels.x0), columns),
                          background_depth);
    }
}

}  // namespace

const Frame& Pipeline::render(const Scene& scene, const View& view) {
    const ViewSetup setup(view, rules_);
    const auto make_frame = [&] {  // 8 bytes a pixel to be filled: worth a thread
        if (frame_.size() != setup.size) frame_ = Frame(setup.size);
    };
    tbb::parallel_invoke(make_frame, [&] {
        projected_.fill(scene.vertices, setup);
        bins_.fill(scene, projected_, setup);
    });
    tbb::parallel_for(std::size_t{0}, bins_.tiles().count(), [&](std::size_t i) {
        const PixelRect pixels = bins_.tiles().pixels(i, setup.size);
        if (bins_.is_empty(i)) return clear(frame_, pixels);
        Tile tile(pixels, setup);
        for (const BinnedRun& run : bins_.runs()) tile.draw(kernel_, run.triangles(), run.places_in(i));
        tile.resolve(frame_);
    });
    return frame_;
}

Plane<std::uint32_t> Pipeline::count_fragments(const Scene& scene, const View& view) {
    const ViewSetup setup(view, rules_);
    Plane<std::uint32_t> fragments(setup.size);
    projected_.fill(scene.vertices, setup);
    bins_.fill(scene, projected_, setup);
    tbb::parallel_for(std::size_t{0}, bins_.tiles().count(), [&](std::size_t i) {
        TileCount tile(bins_.tiles().pixels(i, setup.size), setup);
        for (const BinnedRun& run : bins_.runs()) tile.add(kernel_, run.triangles(), run.places_in(i));
        tile.resolve(fragments);
    });
    return fragments;
}

Frame render_by(const Rules& rules, const Scene& scene, const View& view, const Kernel& kernel) {
    Pipeline pipeline(rules, kernel);
    pipeline.render(scene, view);
    return pipeline.take_frame();
}

Plane<std::uint32_t> count_fragments(const Rules& rules, const Scene& scene, const View& view) {
    return Pipeline(rules).count_fragments(scene, view);
}

}  // namespace zproof::rasterizer
