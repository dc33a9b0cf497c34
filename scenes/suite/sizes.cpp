#include <array>

#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::suite {

namespace {

/// A wavy curtain of 2 x 64 x 64 triangles that hides all behind depth 10 of a view along -z.
void add_curtain(MeshBuilder& mesh) {
    mesh.begin_part("curtain", {0.4, 0.45, 0.6});
    add_sheet(mesh, {.across = 64, .down = 64}, [](double s, double t) {
        const glm::dvec2 wave = unit_circle(3 * s + t);
        return glm::dvec3{24 * s - 12, 12 - 24 * t, -10 + wave.x};
    });
    mesh.begin_part("balls", {0.7, 0.4, 0.2});
    for (int i = 0; i < 25; ++i)
        add_sphere(mesh, {{2.0 * (i % 5) - 4, 2.0 * (i / 5) - 4, -7}, glm::dmat3(0.7)},
                   {.across = 24, .down = 12});
}

View sized_view(ImageSize size, const char* name) {
    return perspective_view(name, size, {}, {.half_height = 0.5, .near_depth = 1, .far_depth = 100});
}

/// Its pixels are `stretch` times as wide as high.
View stretched_view(ImageSize size, double stretch, const char* name) {
    View view = sized_view(size, name);
    view.camera.window.left *= stretch;
    view.camera.window.right *= stretch;
    return view;
}

/// A row or a column of the curtain: one pixel as large as any other.
View narrow_view(ImageSize size, double pixel, const char* name) {
    View view = sized_view(size, name);
    view.camera.window = {-0.5 * pixel * size.width, 0.5 * pixel * size.width, -0.5 * pixel * size.height,
                          0.5 * pixel * size.height};
    return view;
}

}  // namespace

Loaded picture_sizes(ImageSize) {
    MeshBuilder mesh("picture_sizes");
    add_curtain(mesh);
    return mesh.finish({stretched_view({320, 200}, 1.75, "wide-pixels"),
                        stretched_view({200, 320}, 0.375, "high-pixels"),
                        sized_view({.width = 1, .height = 1}, "one-pixel"),
                        narrow_view({.width = 1, .height = 97}, 0.01, "one-column"),
                        narrow_view({.width = 131, .height = 1}, 0.01, "one-row"),
                        sized_view({.width = 37, .height = 101}, "odd"),
                        sized_view({.width = 66, .height = 130}, "two-beyond-64"),
                        narrow_view({.width = 8209, .height = 5}, 0x1p-13, "wider-than-8192"),
                        narrow_view({.width = 3, .height = 8195}, 0x1p-13, "higher-than-8192")});
}

}  // namespace zproof::suite
