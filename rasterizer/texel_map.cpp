#include "rasterizer/texel_map.h"

#include <algorithm>
#include <array>
#include <vector>

#include "rasterizer/surface.h"

namespace zproof::rasterizer {

namespace {

/// The weight of the corner opposite to p and q, dot(cross(p - from, q - from), to), as a functional of the
/// raster position. One of from and to is the same for all positions, so it is affine.
Affine<double> opposite_weight(const PixelRays& lines, Projection projection, const glm::dvec3& p,
                               const glm::dvec3& q) {
    if (projection == Projection::perspective) {
        const glm::dvec3 n = glm::cross(p, q);
        return {glm::dot(n, lines.per_x.to), glm::dot(n, lines.per_y.to), glm::dot(n, lines.origin.to)};
    }
    const glm::dvec3 along = lines.origin.to, n = glm::cross(p - q, along);
    return {glm::dot(n, lines.per_x.from), glm::dot(n, lines.per_y.from),
            glm::dot(n, lines.origin.from) + glm::dot(glm::cross(p, q), along)};
}

Homography<double> scaled(const Homography<double>& map, double factor) {
    return {factor * map.u, factor * map.v, factor * map.w};
}

Homography<double> weighted(const std::array<Affine<double>, 3>& weights,
                            const std::array<TexturedCorner, 3>& corners) {
    const auto sum = [&](double a, double b, double c) {
        return a * weights[0] + b * weights[1] + c * weights[2];
    };
    const auto& [a, b, c] = corners;
    return {sum(a.texel.x, b.texel.x, c.texel.x), sum(a.texel.y, b.texel.y, c.texel.y), sum(1, 1, 1)};
}

/// A corner in the image.
struct DrawnCorner {
    glm::dvec2 p_raster{0}, texel{0};
};

DrawnCorner drawn(const View& view, const TexturedCorner& corner) {
    const Camera& c = view.camera;
    const double depth = -glm::dot(corner.from_eye, c.back);
    glm::dvec2 p{glm::dot(corner.from_eye, c.right), glm::dot(corner.from_eye, c.up)};
    p = c.projection == Projection::perspective ? p / depth : p - depth * c.shear;
    return {{(p.x - c.window.left) / (c.window.right - c.window.left) * view.width,
             (c.window.top - p.y) / (c.window.top - c.window.bottom) * view.height},
            corner.texel};
}

/// Sutherland and Hodgman 1974, one plane.
std::vector<TexturedCorner> in_front_of_near(const Camera& camera,
                                             const std::array<TexturedCorner, 3>& corners) {
    const auto beyond_near = [&](const TexturedCorner& c) {
        return -glm::dot(c.from_eye, camera.back) - camera.near_depth;
    };
    std::vector<TexturedCorner> kept;
    for (std::size_t i = 0; i < 3; ++i) {
        const TexturedCorner &from = corners[i], &to = corners[(i + 1) % 3];
        const double a = beyond_near(from), b = beyond_near(to), share = a / (a - b);
        if (a >= 0) kept.push_back(from);
        if ((a >= 0) != (b >= 0))
            kept.push_back(
                {glm::mix(from.from_eye, to.from_eye, share), glm::mix(from.texel, to.texel, share)});
    }
    return kept;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The functional that is 0 at a and b and 1 at c.
Affine<double> one_at(const glm::dvec2& c, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double scale = 1 / cross(along, c - a);
    return {-along.y * scale, along.x * scale, -cross(along, a) * scale};
}

Homography<double> affine_between(const std::array<DrawnCorner, 3>& drawn) {
    const auto& [a, b, c] = drawn;
    const std::array weights{one_at(a.p_raster, b.p_raster, c.p_raster),
                             one_at(b.p_raster, c.p_raster, a.p_raster),
                             one_at(c.p_raster, a.p_raster, b.p_raster)};
    const auto sum = [&](double at_a, double at_b, double at_c) {
        return at_a * weights[0] + at_b * weights[1] + at_c * weights[2];
    };
    return {sum(a.texel.x, b.texel.x, c.texel.x), sum(a.texel.y, b.texel.y, c.texel.y), {0, 0, 1}};
}

}  // namespace

const Material& material_of(const Scene& scene, std::uint32_t triangle) {
    const auto after = std::ranges::upper_bound(scene.parts, triangle, {}, &Part::first_triangle);
    return scene.materials[std::size_t(std::prev(after)->material)];
}

std::optional<Homography<double>> texels_from_raster(const Scene& scene, const View& view,
                                                     std::uint32_t triangle) {
    const auto corners = textured_corners(scene, view, triangle);
    if (!corners) return {};
    const glm::dvec3 a = (*corners)[0].from_eye, b = (*corners)[1].from_eye, c = (*corners)[2].from_eye;
    const PixelRays lines = pixel_rays(view);
    const Projection projection = view.camera.projection;
    const Homography<double> map =
        weighted({opposite_weight(lines, projection, b, c), opposite_weight(lines, projection, c, a),
                  opposite_weight(lines, projection, a, b)},
                 *corners);
    // What makes w 1 / depth: det [a b c] in perspective; in parallel the sum of weights, which is a number.
    const double whole = projection == Projection::perspective ? glm::dot(a, glm::cross(b, c)) : map.w.c;
    if (whole == 0) return {};
    return scaled(map, 1 / whole);
}

std::optional<Homography<double>> affine_texels_from_raster(const Scene& scene, const View& view,
                                                            std::uint32_t triangle,
                                                            const glm::dvec2& p_raster) {
    const auto corners = textured_corners(scene, view, triangle);
    if (!corners) return {};
    std::vector<DrawnCorner> outline;
    for (const TexturedCorner& corner : in_front_of_near(view.camera, *corners))
        outline.push_back(drawn(view, corner));
    if (outline.size() < 3) return {};
    const auto side = [&](const glm::dvec2& p) {
        return cross(outline[2].p_raster - outline[0].p_raster, p - outline[0].p_raster);
    };
    const bool is_second = outline.size() == 4 && (side(p_raster) > 0) == (side(outline[3].p_raster) > 0);
    if (is_second) return affine_between({outline[0], outline[2], outline[3]});
    return affine_between({outline[0], outline[1], outline[2]});
}

std::optional<std::array<glm::dvec2, 3>> texels_of(const Scene& scene, const Texture& texture,
                                                   std::uint32_t triangle) {
    if (std::size_t(texture.uv_set) >= scene.vertices.uv.size()) return {};
    const auto& uv = scene.vertices.uv[std::size_t(texture.uv_set)];
    const Image& image = scene.images[std::size_t(texture.image)];
    const glm::dvec2 size{image.width, image.height};
    std::array<glm::dvec2, 3> texels;
    for (int i = 0; i < 3; ++i)
        texels[std::size_t(i)] = (texture.transform.translation +
                                  texture.transform.linear * glm::dvec2{uv[scene.triangles[triangle][i]]}) *
                                 size;
    return texels;
}

std::optional<std::array<TexturedCorner, 3>> textured_corners(const Scene& scene, const View& view,
                                                              std::uint32_t triangle) {
    const Texture& texture = material_of(scene, triangle).base_color;
    if (texture.image == Texture::none) return {};
    const auto texels = texels_of(scene, texture, triangle);
    if (!texels) return {};
    std::array<TexturedCorner, 3> corners;
    for (int i = 0; i < 3; ++i)
        corners[std::size_t(i)] = {glm::dvec3{scene.vertices.position_world[scene.triangles[triangle][i]]} -
                                       glm::dvec3{view.camera.eye_world},
                                   (*texels)[std::size_t(i)]};
    return corners;
}

}  // namespace zproof::rasterizer
