#include "compare/first_pass/error_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "compare/memory.h"
#include "compare/witness.h"

namespace zproof {

namespace {

constexpr int tile_width = 64, band_rows = 16;
constexpr std::size_t remembered_triangles = 512;

/// One thread's look at one renderer's depths.
class ErrorMapper {
  public:
    ErrorMapper(const Scene& scene, const Witness& witness, Plane<float>& map)
        : triangle_count_(scene.triangles.size()),
          witness_(witness),
          map_(map),
          triangles_(remembered_triangles) {}

    /// Pixels [left, right) of a row.
    void map(int left, int right, int y) {
        const auto ids = witness_.frame().primitive.row(y);
        for (int x = left; x < right;) {
            const PrimitiveId id = ids[std::size_t(x)];
            int end = x + 1;
            while (end < right && ids[std::size_t(end)] == id) ++end;
            if (std::size_t(id) < triangle_count_) map_run(id, x, end, y);
            x = end;
        }
    }

  private:
    void map_run(PrimitiveId id, int begin, int end, int y) {
        const TriangleDepth& triangle = triangles_(
            std::uint32_t(id), [&] { return depth_of(witness_.triangle_in_view(id), witness_.bounds()); });
        const auto depths = witness_.frame().camera_depth.row(y);
        for (int x = begin; x < end; ++x)
            map_.at(x, y) = float(error_over_bound(triangle.at(x, y), depths[std::size_t(x)]));
    }

    std::size_t triangle_count_;
    const Witness& witness_;
    Plane<float>& map_;
    Memory<std::uint32_t, TriangleDepth> triangles_;
};

}  // namespace

Plane<float> error_over_bound(const Scene& scene, const View& view, const Testimony& testimony) {
    const Resolution size{view.width, view.height};
    if (testimony.frame.size() != size)
        throw std::invalid_argument("error_over_bound: the frame is not of the view's size");
    const Witness witness(scene, view, testimony);
    Plane<float> map(size, std::numeric_limits<float>::quiet_NaN());
    tbb::parallel_for(0, (view.height + band_rows - 1) / band_rows, [&](int band) {
        ErrorMapper mapper(scene, witness, map);
        const int top = band * band_rows, bottom = std::min(top + band_rows, view.height);
        for (int left = 0; left < view.width; left += tile_width)
            for (int y = top; y < bottom; ++y) mapper.map(left, std::min(left + tile_width, view.width), y);
    });
    return map;
}

}  // namespace zproof
