#include <cmath>

#include "scenes/filters/scenes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::filters {

namespace {

/// A name that a view may have: "phi-7.5".
std::string view_name(double degrees) {
    const int whole = int(degrees);
    return "phi-" + std::to_string(whole) + (degrees > whole ? ".5" : "");
}

/// The view from the eye of the worked set-up, turned by phi about the vertical through it: what it sees is
/// the texture turned by phi about the point below the eye.
View turned_view(ImageSize size, double degrees) {
    const glm::dvec2 pitch = suite::unit_circle(20.0 / 360), turn = suite::unit_circle(degrees / 360);
    const glm::dvec3 eye{0, 1, 0}, ahead{-turn.y * pitch.x, -pitch.y, -turn.x * pitch.x};
    return suite::perspective_view(
        view_name(degrees), size, {.eye_world = eye, .target_world = eye + ahead},
        {.half_height = 1 / std::sqrt(3.0), .near_depth = 0.125, .far_depth = 65536});
}

}  // namespace

Loaded ground(const std::string& name, Image image, ImageSize size, double step) {
    const glm::dvec2 texels{image.width, image.height};
    Texture texture = image_texture(0);
    texture.transform.linear = {{128 / texels.x, 0}, {0, 128 / texels.y}};
    texture.transform.translation = glm::dvec2{3.37, 1.71} / texels;
    TexturedMesh mesh(name);
    mesh.begin_part("ground", texture);
    // One triangle, so that no edge runs through the picture; uv is (x, -z), exact in float32.
    mesh.triangle({Corner{{-16384, 0, 8192}, {-16384, -8192}}, Corner{{16384, 0, 8192}, {16384, -8192}},
                   Corner{{0, 0, -32768}, {0, 32768}}});
    std::vector<View> views;
    for (double degrees = 0; degrees <= 90; degrees += step) views.push_back(turned_view(size, degrees));
    std::vector<Image> images;
    images.push_back(std::move(image));
    return mesh.finish(std::move(images), std::move(views));
}

Loaded worked(ImageSize size) { return ground("worked", lattice_checks(), size); }
Loaded checker_plane(ImageSize size) { return ground("checker_plane", checks({}), size); }
Loaded zone_plate_plane(ImageSize size) { return ground("zone_plate_plane", zone_plate(), size, 45); }
Loaded lines_plane(ImageSize size) { return ground("lines_plane", lines(), size, 22.5); }
Loaded text_plane(ImageSize size) { return ground("text_plane", text(), size, 22.5); }
Loaded white_noise_plane(ImageSize size) { return ground("white_noise_plane", white_noise(), size, 45); }
Loaded pink_noise_plane(ImageSize size) { return ground("pink_noise_plane", pink_noise({}), size, 45); }
Loaded impulse_plane(ImageSize size) { return ground("impulse_plane", impulses(), size, 45); }
Loaded npot_plane(ImageSize size) { return ground("npot_plane", checks({640, 427}), size, 22.5); }
Loaded npot_odd_plane(ImageSize size) { return ground("npot_odd_plane", pink_noise({257, 129}), size, 22.5); }

}  // namespace zproof::filters
