#include "rasterizer/tile.h"

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

TileWork Tile::work(const Triangles& triangles, std::span<const std::uint32_t> places) noexcept {
    return {triangles, places.data(), std::uint32_t(places.size()), samples_, values_, hierarchical_z_};
}

void Tile::draw(const Triangles& triangles, std::span<const std::uint32_t> places) noexcept {
    const auto draw = hierarchical_z_ == HierarchicalZ::blocks ? kernel_.draw : kernel_.draw_every_block;
    draw(work(triangles, places));
}

void Tile::draw_tallied(const Triangles& triangles, std::span<const std::uint32_t> places,
                        Tally& tally) noexcept {
    TileWork counted = work(triangles, places);
    counted.tally = &tally;
    kernel_.draw_tallied(counted);
}

void Tile::draw_shaded(const Triangles& triangles, std::span<const std::uint32_t> places,
                       const FragmentShader& shader) {
    TileWork shaded = work(triangles, places);
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

void TileCount::add(const Triangles& triangles, std::span<const std::uint32_t> places) noexcept {
    kernel_.count({triangles, places.data(), std::uint32_t(places.size()), samples_, values_});
}

void TileCount::resolve(Plane<std::uint32_t>& fragments) const noexcept {
    for (int y = pixels_.y0; y < pixels_.y1; ++y)
        for (int x = pixels_.x0; x < pixels_.x1; ++x)
            fragments.at(x, y) = values_.primitive[place_in_tile(x - pixels_.x0, y - pixels_.y0)];
}

}  // namespace zproof::rasterizer
