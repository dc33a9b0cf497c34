#include "rasterizer/pipeline.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "rasterizer/shader.h"
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

/// Visits the tiles in parallel. Frames that are resolved into are whole afterwards.
template <class Visit>
void Pipeline::for_each_tile(const Visit& visit) const {
    const tbb::blocked_range<std::size_t> tiles{0, bins_.tiles().count()};
    tbb::parallel_for(tiles, [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) visit(i);
        kernel_.publish();
    });
}

ViewSetup Pipeline::prepare(const Scene& scene, const View& view, const std::vector<Chunk>& chunks) {
    const ViewSetup setup(view, rules_, optimizations_);
    if (need_chunks(optimizations_)) {
        list_ = draw_list(chunks, view, optimizations_);
        projected_.fill(scene.vertices, setup, list_.vertices);
        bins_.fill(scene, projected_, setup, list_.triangles);
    } else {
        projected_.fill(scene.vertices, setup);
        bins_.fill(scene, projected_, setup);
    }
    return setup;
}

/// Is what was prepared to be drawn the nearest first?
bool Pipeline::put_in_order(const ViewSetup& setup) {
    const bool is_wanted =
        optimizations_.order == DrawOrder::front_to_back ||
        (optimizations_.order == DrawOrder::front_to_back_where_deep && front_to_back_pays(bins_.tally()));
    if (!is_wanted || setup.hierarchical_z == HierarchicalZ::none) return false;
    front_to_back_.fill(bins_);
    return true;
}

TileEntries Pipeline::entries_in(std::size_t tile, bool front_to_back) {
    const std::span<const std::uint32_t> entries = bins_.entries_in(tile);
    return front_to_back ? front_to_back_.ordered(entries) : TileEntries{entries};
}

const Frame& Pipeline::render(const Scene& scene, const View& view, const std::vector<Chunk>& chunks) {
    const ViewSetup setup = prepare(scene, view, chunks);
    const bool front_to_back = put_in_order(setup);
    if (frame_.size() != setup.size) frame_ = Frame::unwritten(setup.size);
    for_each_tile([&](std::size_t i) {
        const PixelRect pixels = bins_.tiles().pixels(i, setup.size);
        if (bins_.entries_in(i).empty()) return clear(frame_, pixels);
        Tile tile(kernel_, pixels, setup);
        tile.draw(bins_.triangles(), entries_in(i, front_to_back));
        tile.resolve(frame_);
    });
    return frame_;
}

Plane<std::uint32_t> Pipeline::count_fragments(const Scene& scene, const View& view) {
    const ViewSetup setup = prepare(scene, view, {});
    Plane<std::uint32_t> fragments(setup.size);
    for_each_tile([&](std::size_t i) {
        TileCount tile(kernel_, bins_.tiles().pixels(i, setup.size), setup);
        tile.add(bins_.triangles(), bins_.entries_in(i));
        tile.resolve(fragments);
    });
    return fragments;
}

Work Pipeline::count_work(const Scene& scene, const View& view, const std::vector<Chunk>& chunks) {
    const ViewSetup setup = prepare(scene, view, chunks);
    const bool front_to_back = put_in_order(setup);
    std::vector<IndexRange> vertices{{0, std::uint32_t(scene.vertices.position_world.size())}};
    Work work;
    work.bins = bins_.tally();
    if (need_chunks(optimizations_)) {
        vertices = list_.vertices;
        work.chunks_culled = list_.culled;
    }
    for (const IndexRange& range : vertices) work.vertices += range.end - range.begin;
    work.pixels = setup.size.pixel_count();
    Frame frame(setup.size);
    std::vector<Tally> tallies(bins_.tiles().count());
    for_each_tile([&](std::size_t i) {
        Tile tile(kernel_, bins_.tiles().pixels(i, setup.size), setup);
        tile.draw_tallied(bins_.triangles(), entries_in(i, front_to_back), tallies[i]);
        tile.resolve(frame);
    });
    for (std::size_t i = 0; i < tallies.size(); ++i) {
        work.tally.blocks += tallies[i].blocks;
        work.tally.hidden_blocks += tallies[i].hidden_blocks;
        work.tally.fragments += tallies[i].fragments;
        work.tally.written += tallies[i].written;
        work.entries += bins_.entries_in(i).size();
    }
    for (const PrimitiveId id : frame.primitive.pixels()) work.seen += id != PrimitiveId::none ? 1 : 0;
    return work;
}

namespace {

/// The place where one tile's fragments are shaded.
struct TileShading {
    const Shader& shader;
    Picture& picture;
    std::uint64_t shaded = 0;

    static void shade(void* context, PrimitiveId id, int x, int y, DepthTestResult result) {
        TileShading& self = *static_cast<TileShading*>(context);
        const LinearRgb colour = self.shader.colour_at(x, y, id);
        ++self.shaded;
        if (result == DepthTestResult::kept) self.picture.at(x, y) = colour;
    }
};

}  // namespace

ShadedFrame Pipeline::render_shaded(const Scene& scene, const View& view, const Light& light,
                                    ShadingTime time, const std::vector<Chunk>& chunks) {
    ViewSetup setup = prepare(scene, view, chunks);
    if (time == ShadingTime::before_the_test) setup.hierarchical_z = HierarchicalZ::none;
    const Shader shader(scene, view, light);
    ShadedFrame frame{Picture(setup.size), 0};
    std::vector<std::uint64_t> shaded(bins_.tiles().count());
    for_each_tile([&](std::size_t i) {
        TileShading context{shader, frame.picture};
        Tile tile(kernel_, bins_.tiles().pixels(i, setup.size), setup);
        tile.draw_shaded(bins_.triangles(), {bins_.entries_in(i)}, {TileShading::shade, &context, time});
        shaded[i] = context.shaded;
    });
    for (const std::uint64_t count : shaded) frame.shaded += count;
    return frame;
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
