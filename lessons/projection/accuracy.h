/// What rounding does to a scene's vertices on each route: how far they come to lie from their exact place,
/// whether the pixel is still the same, and which operation lost it.
///
/// The exact place is that of the same route in rational arithmetic. Between two operations the point so far
/// is handed to exact arithmetic and brought to raster space without further error: where it then lies tells
/// what the operations before have cost. These costs, operation by operation, add up to the whole error.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::study::projection {

struct Spread {
    double median = 0, p99 = 0, largest = 0;  ///< 0 of nothing
};

/// An operation of a route, in numbers of one type.
struct OperationScore {
    std::string stage, operation;
    double mean_px = 0, largest_px = 0;  ///< of what it moves a vertex by, in x or y, whichever is more
    std::uint64_t pixels_lost = 0;       ///< see LostPixel
};

/// A route in numbers of one type.
struct RouteScore {
    std::string route, numbers;     ///< "stages", "float32"
    Spread px, ulp;                 ///< of vertices on the canvas, in x or y, whichever is more
    std::uint64_t other_pixel = 0;  ///< vertices on the canvas whose integer pixel is another
    std::uint64_t other_side = 0;   ///< vertices called on the canvas that are not, or the reverse
    std::uint64_t no_number = 0;    ///< vertices on the canvas that come out infinite or NaN
    std::vector<OperationScore> operations;
};

struct VertexError {
    double px = 0;   ///< in x or y, whichever is more; NaN where no number came out
    double ulp = 0;  ///< the same in units of the last place of the exact coordinate
};

struct VertexRow {
    std::uint32_t vertex = 0;         ///< index into Scene::vertices
    double x = 0, y = 0, depth = 0;   ///< exact raster position and camera depth, cut to double
    std::vector<VertexError> errors;  ///< by ViewAccuracy::routes
};

/// A vertex whose integer pixel is another than the exact one.
struct LostPixel {
    std::uint32_t vertex = 0;
    std::string route, numbers;
    double x = 0, y = 0;           ///< exact raster position, cut to double
    int pixel_x = 0, pixel_y = 0;  ///< the exact one
    double got_x = 0, got_y = 0;   ///< the one that came out, whole numbers
    double error_px = 0;
    std::string stage, operation;  ///< the first after which exact arithmetic no longer leads to the pixel
};

struct ViewAccuracy {
    std::uint64_t vertices = 0;    ///< of the scene
    std::uint64_t not_finite = 0;  ///< of them: no place at all, left out
    std::uint64_t studied = 0;     ///< of the rest, evenly spread
    std::uint64_t on_canvas = 0;   ///< of those studied: before the eye and in the picture, its border too
    std::uint64_t off_canvas = 0;  ///< before the eye and beside the picture
    std::uint64_t behind_eye = 0;  ///< on or behind the plane of the eye (perspective): without an image
    std::uint64_t on_pixel_border = 0;  ///< on the canvas, with a coordinate that is a whole number exactly
    std::vector<RouteScore> routes;     ///< float32 and float64 of every route that is the projection
    std::vector<VertexRow> rows;        ///< those on the canvas
    std::vector<LostPixel> lost;        ///< farthest off first
};

/// Runs on the threads of the surrounding tbb::task_arena; the result is the same for any number of them. At
/// most `most` vertices are studied.
ViewAccuracy accuracy_of(const Scene& scene, const View& view, std::size_t most);

}  // namespace zproof::study::projection
