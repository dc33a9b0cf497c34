#include <cmath>

#include "scenes/filters/scenes.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::filters {

namespace {

/// The camera at the origin sees [-aspect, aspect] x [-1, 1] of the plane z = -1.
View facing_view(ImageSize size) {
    return suite::perspective_view("facing", size, {}, {.half_height = 1, .near_depth = 0.5, .far_depth = 4});
}

/// A rectangle of the image, pixels. It faces the camera, so that the map from the image to its texture is
/// affine: the footprint is the same at every pixel.
struct Field {
    glm::dvec2 from{0}, to{0};
};

/// Charts whose fields show so much of a texture, and not so many texels to a pixel, are laid out for this
/// size: they are the same scene at any other.
constexpr ImageSize paper{512, 512};

/// Column and row of a chart that fills the image but for a margin round every field: 4 pixels, less in small
/// images.
Field field_of(ImageSize size, glm::ivec2 cell, glm::ivec2 cells) {
    const glm::dvec2 step = glm::dvec2{size.width, size.height} / glm::dvec2(cells),
                     from = step * glm::dvec2(cell), margin = glm::min(step / 8.0, 4.0);
    return {from + margin, from + step - margin};
}

/// The point on the plane z = -1 that the facing view shows at a raster position.
glm::dvec3 at_raster(ImageSize size, const glm::dvec2& p_raster) {
    return {2 * p_raster.x / size.height - size.aspect(), 1 - 2 * p_raster.y / size.height, -1};
}

/// The field, showing the texture by texels = jacobian * (pixels from its centre) + (3.37, 1.71) + texels
/// / 2.
void add_field(TexturedMesh& mesh, ImageSize size, const Field& field, const glm::dmat2& jacobian) {
    const glm::dvec2 centre = (field.from + field.to) / 2.0, texels{512, 512};
    const auto corner = [&](double x, double y) {
        const glm::dvec2 p{x, y}, place = jacobian * (p - centre) + glm::dvec2{3.37, 1.71} + texels / 2.0;
        return Corner{at_raster(size, p), glm::vec2(place / texels)};
    };
    mesh.quad({corner(field.from.x, field.from.y), corner(field.from.x, field.to.y),
               corner(field.to.x, field.to.y), corner(field.to.x, field.from.y)});
}

glm::dmat2 rotation(double degrees) {
    const glm::dvec2 turn = suite::unit_circle(degrees / 360);
    return {turn, {-turn.y, turn.x}};
}

}  // namespace

Loaded tilted_quads(ImageSize size) {
    TexturedMesh mesh("tilted_quads");
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 7; ++column) {
            const int anisotropy = 1 << column, roll = 15 * row;
            mesh.begin_part("anisotropy " + std::to_string(anisotropy) + ", roll " + std::to_string(roll),
                            image_texture(0));
            // The footprint is 1.25 texels narrow and its long axis lies at `roll` to the texture's u.
            const glm::dmat2 jacobian =
                rotation(roll) * glm::dmat2{1.25 * anisotropy, 0, 0, 1.25} * rotation(-30);
            add_field(mesh, size, field_of(size, {column, row}, {7, 7}), jacobian);
        }
    return mesh.finish({pink_noise({})}, {facing_view(size)});
}

Loaded lod_ramp(ImageSize size) {
    TexturedMesh mesh("lod_ramp");
    for (int step = 0; step < 32; ++step) {
        mesh.begin_part("lod " + std::to_string(step - 8) + " / 4", image_texture(0));
        const double texels_per_pixel = std::sqrt(std::sqrt(std::ldexp(1.0, step - 8)));
        add_field(mesh, size, field_of(size, {step % 8, step / 8}, {8, 4}), glm::dmat2(texels_per_pixel));
    }
    return mesh.finish({coloured_octaves()}, {facing_view(size)});
}

Loaded magnification(ImageSize size) {
    TexturedMesh mesh("magnification");
    for (int step = 0; step < 9; ++step) {
        const double pixels_per_texel = 1.5 + 2.75 * step;
        mesh.begin_part("field " + std::to_string(step), image_texture(step % 3));
        add_field(mesh, size, field_of(size, {step % 3, step / 3}, {3, 3}),
                  rotation(10.0 * step) * glm::dmat2(1 / pixels_per_texel));
    }
    return mesh.finish({text(), checks({}), pink_noise({})}, {facing_view(size)});
}

Loaded seams(ImageSize size) {
    TexturedMesh mesh("seams");
    const std::array wraps{Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            Texture texture = image_texture(0);
            texture.sampler.wrap_u = wraps[std::size_t(column)];
            texture.sampler.wrap_v = wraps[std::size_t(row)];
            mesh.begin_part("wrap " + std::to_string(column) + " " + std::to_string(row), texture);
            const Field field = field_of(paper, {column, row}, {3, 3});
            // Three and a half textures across every field, the middle one in the middle.
            const double texels_per_pixel = 3.5 * 512 / (field.to.x - field.from.x);
            add_field(mesh, paper, field, rotation(7) * glm::dmat2(texels_per_pixel));
        }
    return mesh.finish({checks({})}, {facing_view(size)});
}

/// Six fields, across which a quarter of the texture to eight textures are seen. Strips of 8 texels lie by
/// turns over one part and over four parts of the surface.
Loaded uneven_strips(ImageSize size) {
    TexturedMesh mesh("uneven_strips");
    for (int step = 0; step < 6; ++step) {
        const int count = 16 << step;
        mesh.begin_part("textures " + std::to_string(1 << step) + " / 4", image_texture(0));
        const Field field = field_of(paper, {step % 3, step / 3}, {3, 2});
        const glm::dvec2 extent = field.to - field.from;
        const float bottom = float(count / 64.0 * extent.y / extent.x);
        const auto corner = [&](int strip, float v) {
            const double parts = strip / 2 * 5 + strip % 2;
            return Corner{at_raster(paper, {field.from.x + extent.x * parts / (count / 2 * 5),
                                            v == 0 ? field.from.y : field.to.y}),
                          {float(strip) / 64, v}};
        };
        for (int strip = 0; strip < count; ++strip)
            mesh.quad(
                {corner(strip, 0), corner(strip, bottom), corner(strip + 1, bottom), corner(strip + 1, 0)});
    }
    return mesh.finish({strips()}, {facing_view(size)});
}

}  // namespace zproof::filters
