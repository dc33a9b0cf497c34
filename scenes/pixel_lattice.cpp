#include "scenes/pixel_lattice.h"

namespace zproof {
namespace {

int count(int pixels, int first, int stride) { return (pixels - first + stride - 1) / stride; }

template <class T>
Plane<T> plane_at(const PixelLattice& lattice, const Plane<T>& plane) {
    const Resolution size = size_of(lattice, plane.size());
    Plane<T> some = Plane<T>::unwritten(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            some.at(x, y) =
                plane.at(lattice.first_x + lattice.stride * x, lattice.first_y + lattice.stride * y);
    return some;
}

}  // namespace

Resolution size_of(const PixelLattice& lattice, const Resolution& image) {
    return {count(image.width, lattice.first_x, lattice.stride),
            count(image.height, lattice.first_y, lattice.stride)};
}

View view_of(const PixelLattice& lattice, const View& view) {
    const auto [width, height] = size_of(lattice, {view.width, view.height});
    const Window& whole = view.camera.window;
    const double across_px = (whole.right - whole.left) / view.width;
    const double down_px = (whole.top - whole.bottom) / view.height;
    const double before_centre = 0.5 * (1 - lattice.stride);  // from a pixel's side to that of its cell, px
    View some = view;
    some.width = width;
    some.height = height;
    Window& window = some.camera.window;
    window.left = whole.left + (lattice.first_x + before_centre) * across_px;
    window.right = window.left + lattice.stride * width * across_px;
    window.top = whole.top - (lattice.first_y + before_centre) * down_px;
    window.bottom = window.top - lattice.stride * height * down_px;
    return some;
}

Frame frame_at(const PixelLattice& lattice, const Frame& frame) {
    Frame some;
    some.primitive = plane_at(lattice, frame.primitive);
    some.camera_depth = plane_at(lattice, frame.camera_depth);
    return some;
}

}  // namespace zproof
