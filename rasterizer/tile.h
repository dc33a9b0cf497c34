/// One tile's z-buffer, and the resolve into the frame.
#pragma once

#include <cstdint>
#include <span>

#include "frame/frame.h"
#include "rasterizer/kernel.h"
#include "rasterizer/triangle_setup.h"

namespace zproof::rasterizer {

/// The pixels of one tile while triangles are drawn into it, by a kernel.
class Tile {
  public:
    /// pixels: at most tile_size wide and high.
    Tile(const PixelRect& pixels, const ViewSetup& setup) noexcept;

    /// Triangles of one run, by their places in it.
    void draw(const Kernel& kernel, const TriangleRun& run, std::span<const std::uint32_t> places) noexcept;

    /// Writes ids and camera depths of this tile's pixels.
    void resolve(Frame& frame) const noexcept;

  private:
    PixelRect pixels_;
    DepthFunctional depth_;
    TileSamples samples_;
    TilePixels values_;
};

/// Instead of drawing: how many fragments each pixel of a tile gets, hidden or not.
class TileCount {
  public:
    TileCount(const PixelRect& pixels, const ViewSetup& setup) noexcept;

    void add(const Kernel& kernel, const TriangleRun& run, std::span<const std::uint32_t> places) noexcept;
    void resolve(Plane<std::uint32_t>& fragments) const noexcept;

  private:
    PixelRect pixels_;
    TileSamples samples_;
    TilePixels values_;
};

}  // namespace zproof::rasterizer
