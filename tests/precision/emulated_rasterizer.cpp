#include "tests/precision/emulated_rasterizer.h"

#include <algorithm>
#include <cmath>

#include "tests/precision/emulated_depth.h"
#include "tests/precision/emulated_edges.h"
#include "tests/precision/emulated_vertices.h"

namespace zproof {

namespace {

/// The pixels whose centres may lie between two raster positions, or beyond by errors and a tolerance.
struct PixelRange {
    int first, last;
};
PixelRange pixels_between(double low, double high, int size, double tolerance) {
    const double margin_px = 2 + 2 * tolerance * (high - low);
    const double first = std::clamp(std::floor(low - margin_px), 0.0, double(size));
    const double last = std::clamp(std::ceil(high + margin_px), -1.0, double(size - 1));
    return {int(first), int(last)};
}

class EmulatedRasterizer {
  public:
    EmulatedRasterizer(const RasterPrecision& precision, const View& view)
        : precision_(precision),
          view_(view),
          depth_(view, precision),
          frame_({view.width, view.height}),
          buffer_({view.width, view.height}, depth_.background()) {}

    void draw(std::uint32_t triangle, const EmulatedPolygon& corners) {
        if (precision_.edge_functions == EdgeFunctions::homogeneous)
            return draw_homogeneous(triangle, corners);
        const EmulatedPolygon polygon = emulated_clip(view_, precision_, corners);
        for (std::size_t i = 2; i < polygon.size(); ++i)
            draw_piece(triangle, {polygon[0], polygon[i - 1], polygon[i]});
    }

    Frame frame() && { return std::move(frame_); }

  private:
    using Piece = std::array<EmulatedCorner, 3>;

    double tolerance() const { return precision_.barycentric_tolerance; }

    void draw_piece(std::uint32_t triangle, const Piece& piece) {
        WindowPiece window;
        for (std::size_t i = 0; i < 3; ++i) window[i] = window_point(view_, precision_, piece[i]);
        const EmulatedEdges edges(precision_, window);
        if (!edges.is_drawn()) return;
        const auto [x_low, x_high] = std::minmax({window[0].x, window[1].x, window[2].x});
        const auto [y_low, y_high] = std::minmax({window[0].y, window[1].y, window[2].y});
        const PixelRange across = pixels_between(x_low, x_high, view_.width, tolerance()),
                         down = pixels_between(y_low, y_high, view_.height, tolerance());
        const EmulatedInterpolation interpolation = depth_.on(piece, window);
        for (int y = down.first; y <= down.last; ++y)
            for (int x = across.first; x <= across.last; ++x)
                if (const auto weights = edges.weights_at(sampled_at(view_, x, y)))
                    write(triangle, x, y, interpolation.at(sampled_at(view_, x, y), *weights));
    }

    void draw_homogeneous(std::uint32_t triangle, const EmulatedPolygon& corners) {
        const HomogeneousEdges edges(precision_, view_, {corners[0], corners[1], corners[2]});
        if (!edges.is_drawn()) return;
        PixelRange across{0, view_.width - 1}, down{0, view_.height - 1};
        if (const auto box = edges.box_px()) {
            across = pixels_between(box->low.x, box->high.x, view_.width, tolerance());
            down = pixels_between(box->low.y, box->high.y, view_.height, tolerance());
        }
        for (int y = down.first; y <= down.last; ++y)
            for (int x = across.first; x <= across.last; ++x)
                if (const auto depth = edges.depth_at(sampled_at(view_, x, y)))
                    write(triangle, x, y, {.tested = depth_.key_of_depth(*depth), .shown = *depth});
    }

    void write(std::uint32_t triangle, int x, int y, const EmulatedDepth& depth) {
        const bool has_horizon = view_.camera.projection == Projection::perspective;
        if (has_horizon && !(depth.shown > 0)) return;  // a tolerance reaches beyond it
        if (precision_.nothing_behind_the_eye && depth.shown < 0) return;
        if (!(depth.tested < buffer_.at(x, y))) return;
        buffer_.at(x, y) = depth.tested;
        frame_.primitive.at(x, y) = PrimitiveId{triangle};
        frame_.camera_depth.at(x, y) = depth.shown;
    }

    RasterPrecision precision_;
    View view_;
    EmulatedDepthBuffer depth_;
    Frame frame_;
    Plane<double> buffer_;  ///< the smallest wins
};

}  // namespace

Frame emulate(const RasterPrecision& precision, const Scene& scene, const View& view) {
    const EmulatedTransform transform(view, precision);
    EmulatedPolygon corners;
    for (const glm::vec3& p : scene.vertices.position_world) corners.push_back(transform(p));
    EmulatedRasterizer rasterizer(precision, view);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const glm::uvec3& index = scene.triangles[i];
        rasterizer.draw(std::uint32_t(i), {corners[index.x], corners[index.y], corners[index.z]});
    }
    return std::move(rasterizer).frame();
}

}  // namespace zproof
