#include "rasterizer/tile.h"

#include <algorithm>
#include <limits>

namespace zproof::rasterizer {
namespace {

TileSamples samples_of(const PixelRect& pixels, const ViewSetup& setup) {
    return {.x0 = pixels.x0,
            .y0 = pixels.y0,
            .subpixel_bits = setup.grid.bits,
            .sample_offset = setup.grid.sample_offset,
            .least_of_top_left = least_covered(setup.fill, EdgeKind::top_left),
            .least_of_others = least_covered(setup.fill, EdgeKind::other),
            .columns = pixels.x1 - pixels.x0,
            .rows = pixels.y1 - pixels.y0};
}

}  // namespace

Tile::Tile(const Kernel& kernel, const PixelRect& pixels, const ViewSetup& setup) noexcept
    : kernel_(kernel),
      pixels_(pixels),
      depth_(setup.depth),
      samples_(samples_of(pixels, setup)),
      hierarchical_z_(setup.hierarchical_z) {
    kernel_.clear(values_, std::uint32_t(PrimitiveId::none));
}

/// Closes the pixels beyond the image: nothing wins one, so that the tile can be finished without it.
void Tile::close_beyond_image() noexcept {
    if (samples_.columns == tile_size && samples_.rows == tile_size) return;
    for (int y = 0; y < tile_size; ++y)
        for (int x = y < samples_.rows ? samples_.columns : 0; x < tile_size; ++x)
            values_.inverse_depth[place_in_tile(x, y)] = std::numeric_limits<float>::infinity();
    std::ranges::fill(values_.hiz_of_cell, std::numeric_limits<float>::infinity());
    for (int block = 0; block < TilePixels::blocks; ++block) {
        const float* const first = values_.inverse_depth + std::ptrdiff_t{16} * block;
        const float hiz = *std::min_element(first, first + 16);
        const int cell = block / blocks_in_row / 4 * 4 + block % blocks_in_row / 4;
        values_.hiz[block] = hiz;
        values_.hiz_of_cell[cell] = std::min(values_.hiz_of_cell[cell], hiz);
    }
}

TileWork Tile::work(const Triangles& triangles, const TileEntries& drawn) noexcept {
    return {.triangles = triangles,
            .entries = drawn.entries.data(),
            .count = std::uint32_t(drawn.entries.size()),
            .samples = samples_,
            .pixels = values_,
            .hierarchical_z = hierarchical_z_,
            .ties = drawn.ties,
            .nearest_left = drawn.nearest_left};
}

void Tile::draw(const Triangles& triangles, const TileEntries& drawn) noexcept {
    if (drawn.nearest_left != nullptr) close_beyond_image();
    const auto draw = hierarchical_z_ == HierarchicalZ::blocks ? kernel_.draw : kernel_.draw_every_block;
    draw(work(triangles, drawn));
}

void Tile::draw_tallied(const Triangles& triangles, const TileEntries& drawn, Tally& tally) noexcept {
    TileWork counted = work(triangles, drawn);
    counted.tally = &tally;
    kernel_.draw_tallied(counted);
}

void Tile::draw_shaded(const Triangles& triangles, const TileEntries& drawn, const FragmentShader& shader) {
    TileWork shaded = work(triangles, drawn);
    shaded.shader = &shader;
    kernel_.draw_shaded(shaded);
}

void Tile::resolve(Frame& frame) const noexcept {
    const auto first = std::size_t(pixels_.x0);
    kernel_.resolve({.pixels = values_,
                     .depth = depth_,
                     .camera_depth = frame.camera_depth.row(pixels_.y0).data() + first,
                     .primitive = frame.primitive.row(pixels_.y0).data() + first,
                     .stride = std::size_t(frame.size().width),
                     .columns = pixels_.x1 - pixels_.x0,
                     .rows = pixels_.y1 - pixels_.y0});
}

TileCount::TileCount(const Kernel& kernel, const PixelRect& pixels, const ViewSetup& setup) noexcept
    : kernel_(kernel), pixels_(pixels), samples_(samples_of(pixels, setup)) {
    kernel_.clear(values_, 0);
}

void TileCount::add(const Triangles& triangles, std::span<const std::uint32_t> entries) noexcept {
    kernel_.count({triangles, entries.data(), std::uint32_t(entries.size()), samples_, values_});
}

void TileCount::resolve(Plane<std::uint32_t>& fragments) const noexcept {
    for (int y = pixels_.y0; y < pixels_.y1; ++y)
        for (int x = pixels_.x0; x < pixels_.x1; ++x)
            fragments.at(x, y) = values_.primitive[place_in_tile(x - pixels_.x0, y - pixels_.y0)];
}

}  // namespace zproof::rasterizer
