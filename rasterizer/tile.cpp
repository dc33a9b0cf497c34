#include "rasterizer/tile.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace zproof::rasterizer {
namespace {

constexpr float nothing_seen = -std::numeric_limits<float>::infinity();

/// floor(n / d) for d > 0, cut to [0, tile_size]. Exact although it divides doubles: n and d are integers <
/// 2^53; a quotient that is no integer lies at least 1 / d >= 2^-33 from the next, and within the tile it is
/// rounded by at most 2^-47. Both bounds come from the guard band.
int floor_quotient_in_tile(std::int64_t n, std::int64_t d) noexcept {
    const double quotient = double(n) / double(d);
    return static_cast<int>(std::clamp(quotient, 0.0, double{tile_size}));
}

/// `condition ? a : b` in bit operations; written so, gcc 12 vectorizes the loops below. Both are 32 bits.
template <class T>
constexpr T chosen(bool condition, T a, T b) noexcept {
    const std::uint32_t mask = -std::uint32_t{condition};
    return std::bit_cast<T>((std::bit_cast<std::uint32_t>(a) & mask) |
                            (std::bit_cast<std::uint32_t>(b) & ~mask));
}

}  // namespace

/// One triangle in one tile. Columns count from column0, rows from the tile's top.
struct Tile::Scan {
    PrimitiveId id = PrimitiveId::none;
    int column0 = 0, columns = 0;
    std::array<EdgeFunction, 3> edges{};  ///< a and b in units of whole pixels
    std::array<double, 3> weight{};       ///< nearness of vertex i, divided by 2A
};

/// The columns [first, end) of one row whose samples all edges cover: E + a i >= least, solved for i.
Tile::Span Tile::covered(const Scan& scan, const EdgeValues& row_start) noexcept {
    Span span{0, scan.columns};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t a = scan.edges[k].a;
        const std::int64_t margin = row_start[k] - scan.edges[k].least;
        if (a > 0) span.first = std::max(span.first, floor_quotient_in_tile(a - 1 - margin, a));
        if (a < 0) span.end = std::min(span.end, floor_quotient_in_tile(margin - a, -a));
        if (a == 0 && margin < 0) span.end = 0;
    }
    return span;
}

Tile::Tile(const PixelRect& pixels, const ViewSetup& setup) noexcept : pixels_(pixels), setup_(setup) {
    for (auto& row : nearness_) row.fill(nothing_seen);
    for (auto& row : primitive_) row.fill(PrimitiveId::none);
}

template <class Row>
void Tile::for_each_row(const SnappedTriangle& triangle, Row row) const noexcept {
    const PixelRect box = pixels_within(triangle, setup_);
    const int x0 = std::max(box.x0, pixels_.x0), x1 = std::min(box.x1, pixels_.x1);
    const int y0 = std::max(box.y0, pixels_.y0), y1 = std::min(box.y1, pixels_.y1);
    const SnappedPoint start{setup_.grid.sample(x0), setup_.grid.sample(y0)};
    Scan scan{.id = triangle.id,
              .column0 = x0 - pixels_.x0,
              .columns = x1 - x0,
              .edges = edges_of(triangle, setup_.fill),
              .weight = {}};
    const double doubled_area = double(scan.edges[0].at(triangle.vertex[0].p));
    EdgeValues row_start;
    for (std::size_t k = 0; k < 3; ++k) {
        row_start[k] = scan.edges[k].at(start);
        scan.edges[k].a *= setup_.grid.steps_per_pixel();
        scan.edges[k].b *= setup_.grid.steps_per_pixel();
        scan.weight[k] = triangle.vertex[k].nearness / doubled_area;
    }
    for (int y = y0; y < y1; ++y) {
        const Span span = covered(scan, row_start);
        if (span.first < span.end) row(scan, row_start, span, y);
        for (std::size_t k = 0; k < 3; ++k) row_start[k] += scan.edges[k].b;
    }
}

void Tile::draw(const SnappedTriangle& triangle) noexcept {
    for_each_row(triangle, [this](const Scan& scan, const EdgeValues& row_start, Span span, int y) {
        draw_row(scan, row_start, span, y - pixels_.y0);
    });
}

void Tile::count(const SnappedTriangle& triangle, Plane<std::uint32_t>& fragments) const noexcept {
    for_each_row(triangle, [&](const Scan& scan, const EdgeValues&, Span span, int y) {
        for (int i = span.first; i < span.end; ++i) ++fragments.at(pixels_.x0 + scan.column0 + i, y);
    });
}

/// Without a branch, so that compilers vectorize it. The doubles e hold integers below 2^53: nothing is
/// rounded until the weights come in.
void Tile::draw_row(const Scan& scan, const EdgeValues& row_start, Span span, int row) noexcept {
    float* const nearness = &nearness_[std::size_t(row)][std::size_t(scan.column0)];
    PrimitiveId* const primitive = &primitive_[std::size_t(row)][std::size_t(scan.column0)];
    const double start0 = double(row_start[0]), step0 = double(scan.edges[0].a), weight0 = scan.weight[0];
    const double start1 = double(row_start[1]), step1 = double(scan.edges[1].a), weight1 = scan.weight[1];
    const double start2 = double(row_start[2]), step2 = double(scan.edges[2].a), weight2 = scan.weight[2];
    const PrimitiveId id = scan.id;
    for (int i = span.first; i < span.end; ++i) {
        const double e0 = start0 + step0 * i;
        const double e1 = start1 + step1 * i;
        const double e2 = start2 + step2 * i;
        const float seen = float((e0 * weight0 + e1 * weight1) + e2 * weight2);
        const float held = nearness[i];
        nearness[i] = seen > held ? seen : held;
        primitive[i] = chosen(seen > held, id, primitive[i]);
    }
}

void Tile::resolve(Frame& frame) const noexcept {
    const DepthFunctional functional = setup_.depth;
    for (int y = pixels_.y0; y < pixels_.y1; ++y) {
        const auto& nearness = nearness_[std::size_t(y - pixels_.y0)];
        const auto& primitive = primitive_[std::size_t(y - pixels_.y0)];
        const auto depth_row = frame.camera_depth.row(y).subspan(std::size_t(pixels_.x0));
        const auto id_row = frame.primitive.row(y).subspan(std::size_t(pixels_.x0));
        const auto columns = std::size_t(pixels_.x1 - pixels_.x0);
        std::copy_n(primitive.begin(), columns, id_row.begin());
        for (std::size_t i = 0; i < columns; ++i) {
            const float depth = functional.depth_of(nearness[i]);
            depth_row[i] = chosen(nearness[i] > nothing_seen, depth, background_depth);
        }
    }
}

}  // namespace zproof::rasterizer
