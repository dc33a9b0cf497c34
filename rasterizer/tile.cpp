#include "rasterizer/tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace zproof::rasterizer {
namespace {

constexpr float nothing_seen = -std::numeric_limits<float>::infinity();

/// `condition ? a : b` in bit operations; written so, gcc 12 vectorizes the loop below. Both are 32 bits.
template <class T>
constexpr T chosen(bool condition, T a, T b) noexcept {
    const std::uint32_t mask = -std::uint32_t{condition};
    return std::bit_cast<T>((std::bit_cast<std::uint32_t>(a) & mask) |
                            (std::bit_cast<std::uint32_t>(b) & ~mask));
}

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

/// One row of a tile, out of its blocks.
template <class Value>
std::array<Value, tile_size> row_of(const Value* values, int y) {
    std::array<Value, tile_size> row;
    for (int x = 0; x < tile_size; x += 4) std::copy_n(values + place_in_tile(x, y), 4, row.begin() + x);
    return row;
}

}  // namespace

Tile::Tile(const PixelRect& pixels, const ViewSetup& setup) noexcept
    : pixels_(pixels),
      depth_(setup.depth),
      samples_(samples_of(pixels, setup)),
      hierarchical_z_(setup.hierarchical_z) {
    std::ranges::fill(values_.nearness, nothing_seen);
    std::ranges::fill(values_.primitive, std::uint32_t(PrimitiveId::none));
    std::ranges::fill(values_.farthest, nothing_seen);
}

TileWork Tile::work(const TriangleRun& run, std::span<const std::uint32_t> places) noexcept {
    return {run, places.data(), std::uint32_t(places.size()), samples_, values_, hierarchical_z_};
}

void Tile::draw(const Kernel& kernel, const TriangleRun& run,
                std::span<const std::uint32_t> places) noexcept {
    const auto draw = hierarchical_z_ == HierarchicalZ::blocks ? kernel.draw : kernel.draw_every_block;
    draw(work(run, places));
}

void Tile::draw_tallied(const Kernel& kernel, const TriangleRun& run, std::span<const std::uint32_t> places,
                        Tally& tally) noexcept {
    TileWork counted = work(run, places);
    counted.tally = &tally;
    kernel.draw_tallied(counted);
}

void Tile::draw_shaded(const Kernel& kernel, const TriangleRun& run, std::span<const std::uint32_t> places,
                       const FragmentShader& shader) {
    TileWork shaded = work(run, places);
    shaded.shader = &shader;
    kernel.draw_shaded(shaded);
}

void Tile::resolve(Frame& frame) const noexcept {
    const auto columns = std::size_t(pixels_.x1 - pixels_.x0);
    for (int y = pixels_.y0; y < pixels_.y1; ++y) {
        const auto nearness = row_of(values_.nearness, y - pixels_.y0);
        const auto primitive = row_of(values_.primitive, y - pixels_.y0);
        const auto depth_row = frame.camera_depth.row(y).subspan(std::size_t(pixels_.x0));
        const auto id_row = frame.primitive.row(y).subspan(std::size_t(pixels_.x0));
        for (std::size_t i = 0; i < columns; ++i) id_row[i] = PrimitiveId{primitive[i]};
        for (std::size_t i = 0; i < columns; ++i) {
            const float depth = depth_.depth_of(nearness[i]);
            depth_row[i] = chosen(nearness[i] > nothing_seen, depth, background_depth);
        }
    }
}

TileCount::TileCount(const PixelRect& pixels, const ViewSetup& setup) noexcept
    : pixels_(pixels), samples_(samples_of(pixels, setup)) {
    std::ranges::fill(values_.primitive, 0u);
    std::ranges::fill(values_.farthest, nothing_seen);
}

void TileCount::add(const Kernel& kernel, const TriangleRun& run,
                    std::span<const std::uint32_t> places) noexcept {
    kernel.count({run, places.data(), std::uint32_t(places.size()), samples_, values_});
}

void TileCount::resolve(Plane<std::uint32_t>& fragments) const noexcept {
    for (int y = pixels_.y0; y < pixels_.y1; ++y) {
        const auto row = row_of(values_.primitive, y - pixels_.y0);
        std::copy_n(row.begin(), pixels_.x1 - pixels_.x0, fragments.row(y).begin() + pixels_.x0);
    }
}

}  // namespace zproof::rasterizer
