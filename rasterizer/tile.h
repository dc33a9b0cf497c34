/// One tile's z-buffer, and the resolve into the frame.
#pragma once

#include <cstdint>
#include <span>

#include "frame/frame.h"
#include "rasterizer/edge_function.h"
#include "rasterizer/kernel.h"
#include "rasterizer/tile_grid.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {

/// Triangles that may cover samples of a tile, in the order of drawing.
struct TileEntries {
    std::span<const std::uint32_t> entries{};
    Ties ties = Ties::first_to_come;
    /// An upper bound of inverse depth, if one is known: element i bounds the pixels of the i-th `batch_size`
    /// entries and of all that follow.
    const float* nearest_left = nullptr;
};

/// The pixels of one tile while triangles are drawn into it, by a kernel.
class Tile {
  public:
    /// pixels: at most tile_size wide and high.
    Tile(const Kernel& kernel, const PixelRect& pixels, const ViewSetup& setup) noexcept;

    void draw(const Triangles& triangles, const TileEntries& drawn) noexcept;
    /// Draws and adds to the tally.
    void draw_tallied(const Triangles& triangles, const TileEntries& drawn, Tally& tally) noexcept;
    /// Draws and hands every fragment to the shader.
    void draw_shaded(const Triangles& triangles, const TileEntries& drawn, const FragmentShader& shader);

    /// Writes ids and camera depths of this tile's pixels. Another thread may look when the kernel has
    /// published them.
    void resolve(Frame& frame) const noexcept;

  private:
    const Kernel& kernel_;
    PixelRect pixels_;
    DepthFunctional depth_;
    TileWork work(const Triangles& triangles, const TileEntries& drawn) noexcept;
    void close_beyond_image() noexcept;

    TileSamples samples_;
    HierarchicalZ hierarchical_z_;
    TilePixels values_;
};

/// Instead of drawing: how many fragments each pixel of a tile gets, hidden or not.
class TileCount {
  public:
    TileCount(const Kernel& kernel, const PixelRect& pixels, const ViewSetup& setup) noexcept;

    void add(const Triangles& triangles, std::span<const std::uint32_t> entries) noexcept;
    void resolve(Plane<std::uint32_t>& fragments) const noexcept;

  private:
    const Kernel& kernel_;
    PixelRect pixels_;
    TileSamples samples_;
    TilePixels values_;
};

}  // namespace zproof::rasterizer
