#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

constexpr int edge_length = 4096;  ///< px; the slower an edge rises, the finer the scale that it is
constexpr int edge_rise = 2;       ///< px over the whole length
constexpr int scale_row = 1;       ///< where the scale is read

constexpr const char* not_where_drawn = "a slanted edge is not where it was drawn; is the image upside down?";

/// An edge rises from (0, 0) to (length, rise), its corners whole pixels on any grid. The number of pixels of
/// the row that lie behind the edge.
int pixels_behind_the_edge(const Renderer& renderer, Axis axis) {
    Scene scene;
    add_triangle(scene, axis, {{{0, 0}, {edge_rise, edge_length}, {4, 0}}});
    const View view = axis == Axis::x ? raster_view(4, edge_length) : raster_view(edge_length, 4);
    const Frame frame = renderer.render(scene, view);
    int count = 0;
    while (count < edge_length && is_covered(frame, axis, scale_row, count)) ++count;
    for (int i = count; i < edge_length; ++i) {
        if (is_covered(frame, axis, scale_row, i)) throw Unmeasurable{not_where_drawn};
    }
    if (count == 0 || count == edge_length) throw Unmeasurable{not_where_drawn};
    return count;
}

/// Pixel i of the row is behind the edge while rise (i + across) / length < row + centre: true of the last
/// pixel behind, false of the next.
Bracket centre_from(int pixels_behind, const Bracket& across) {
    const double per_pixel = double(edge_rise) / edge_length;
    return {per_pixel * (pixels_behind - 1 + across.low) - scale_row,
            per_pixel * (pixels_behind + across.high) - scale_row};
}

}  // namespace

std::array<Bracket, 2> pixel_centre(const Renderer& renderer) {
    const int x_count = pixels_behind_the_edge(renderer, Axis::x);
    const int y_count = pixels_behind_the_edge(renderer, Axis::y);
    Bracket x{-1, 1}, y{-1, 1};
    for (int i = 0; i < 2; ++i) {  // each narrows the other
        x = centre_from(x_count, y);
        y = centre_from(y_count, x);
    }
    return {x, y};
}

}  // namespace zproof::measure
