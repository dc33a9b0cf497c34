#include <algorithm>

#include "tests/mutants/plain/assembly.h"
#include "tests/mutants/plain/methods.h"
#include "tests/mutants/plain/target.h"

namespace plain {
namespace {

constexpr int grid = 256;  ///< steps per pixel
constexpr int tile_size = 16;

struct SnappedTriangle {
    std::array<std::int64_t, 3> x, y;  ///< grid steps; clockwise with y down
    std::array<float, 3> z;
    std::uint32_t id;
};

/// Pixels from first up to, but not including, last.
struct PixelBox {
    int x_first, x_last, y_first, y_last;
};

/// Above 0 inside, 48.16: |value| < 2^52.
struct Edge {
    std::int64_t a, b, c;

    bool owns_its_line() const { return a > 0 || (a == 0 && b > 0); }
    std::int64_t at(int x, int y) const { return a * (x * grid + grid / 2) + b * (y * grid + grid / 2) + c; }
};

std::int64_t snapped(float px) { return std::int64_t(std::nearbyint(px * grid)); }

/// Opposite to corner i.
Edge edge_of(const SnappedTriangle& t, std::size_t i) {
    const std::size_t from = (i + 1) % 3, to = (i + 2) % 3;
    const std::int64_t dx = t.x[to] - t.x[from], dy = t.y[to] - t.y[from];
    return {.a = -dy, .b = dx, .c = dy * t.x[from] - dx * t.y[from]};
}

std::int64_t doubled_area(const SnappedTriangle& t) {
    return (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.x[2] - t.x[0]) * (t.y[1] - t.y[0]);
}

/// The pixels whose centres may lie inside.
PixelBox box_of(const SnappedTriangle& t, const Camera& camera) {
    const auto [x_low, x_high] = std::ranges::minmax(t.x);
    const auto [y_low, y_high] = std::ranges::minmax(t.y);
    return {.x_first = std::max(0, int(x_low / grid)),
            .x_last = std::min(camera.width, int(x_high / grid) + 1),
            .y_first = std::max(0, int(y_low / grid)),
            .y_last = std::min(camera.height, int(y_high / grid) + 1)};
}

/// Triangles, and for each tile those that may touch it, in order.
class Bins {
  public:
    explicit Bins(const Camera& camera)
        : camera_(camera),
          columns_((camera.width + tile_size - 1) / tile_size),
          rows_((camera.height + tile_size - 1) / tile_size),
          bins_(std::size_t(columns_) * std::size_t(rows_)) {}

    void add(const SnappedTriangle& t) {
        const PixelBox box = box_of(t, camera_);
        if (box.x_first >= box.x_last || box.y_first >= box.y_last) return;
        triangles_.push_back(t);
        for (int row = box.y_first / tile_size; row <= (box.y_last - 1) / tile_size; ++row)
            for (int column = box.x_first / tile_size; column <= (box.x_last - 1) / tile_size; ++column)
                bins_[std::size_t(row * columns_ + column)].push_back(std::uint32_t(triangles_.size() - 1));
    }

    template <class DrawInBox>
    void draw_all(DrawInBox draw) const {
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                for (const std::uint32_t index : bins_[std::size_t(row * columns_ + column)])
                    draw(triangles_[index], part_in_tile(box_of(triangles_[index], camera_), column, row));
    }

  private:
    static PixelBox part_in_tile(const PixelBox& box, int column, int row) {
        return {.x_first = std::max(box.x_first, column * tile_size),
                .x_last = std::min(box.x_last, (column + 1) * tile_size),
                .y_first = std::max(box.y_first, row * tile_size),
                .y_last = std::min(box.y_last, (row + 1) * tile_size)};
    }

    const Camera& camera_;
    int columns_, rows_;
    std::vector<SnappedTriangle> triangles_;
    std::vector<std::vector<std::uint32_t>> bins_;
};

float weighted_z(const SnappedTriangle& t, const std::array<std::int64_t, 3>& e, float area) {
    return (float(e[0]) / area * t.z[0] + float(e[1]) / area * t.z[1]) + float(e[2]) / area * t.z[2];
}

void draw_in_box(const SnappedTriangle& t, const PixelBox& box, Target& target) {
    const std::array edges{edge_of(t, 0), edge_of(t, 1), edge_of(t, 2)};
    const auto area = float(doubled_area(t));
    for (int y = box.y_first; y < box.y_last; ++y)
        for (int x = box.x_first; x < box.x_last; ++x) {
            const std::array e{edges[0].at(x, y), edges[1].at(x, y), edges[2].at(x, y)};
            bool is_inside = true;
            for (std::size_t i = 0; i < 3; ++i)
                is_inside = is_inside && (e[i] > 0 || (e[i] == 0 && edges[i].owns_its_line()));
            if (is_inside) target.draw(x, y, weighted_z(t, e, area), t.id);
        }
}

}  // namespace

Picture draw_tiled(const Mesh& mesh, const Camera& camera, DepthBuffer buffer) {
    Bins bins(camera);
    using Corner = RasterVertex<float>;
    assemble<float>(mesh, camera, buffer,
                    [&](const Corner& a, const Corner& b, const Corner& c, std::uint32_t id) {
                        SnappedTriangle t{.x = {snapped(a.x), snapped(b.x), snapped(c.x)},
                                          .y = {snapped(a.y), snapped(b.y), snapped(c.y)},
                                          .z = {a.z, b.z, c.z},
                                          .id = id};
                        if (doubled_area(t) < 0) {
                            std::swap(t.x[1], t.x[2]);
                            std::swap(t.y[1], t.y[2]);
                            std::swap(t.z[1], t.z[2]);
                        }
                        if (doubled_area(t) > 0) bins.add(t);
                    });
    Target target(camera, buffer);
    bins.draw_all([&](const SnappedTriangle& t, const PixelBox& box) { draw_in_box(t, box, target); });
    return target.finished();
}

}  // namespace plain
