/// The scene as the image sees it: triangles as half-planes, and the colours on them.
#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "filters/area/seen_triangle.h"
#include "texture/linear_image.h"

namespace zproof::oracle::area {

/// A material's albedo. Without an image it is the factor alone.
struct SurfaceColour {
    glm::dvec3 factor{1};
    const texture::LinearImage* image = nullptr;  ///< owned by Surfaces
    texture::Addressing addressing{};

    /// The place in the image of a column, or row, of the endless line.
    int column(std::int64_t index) const { return inside(addressing.u, index, image->width); }
    int row(std::int64_t index) const { return inside(addressing.v, index, image->height); }
    /// Linear RGB without the factor; within the image.
    glm::dvec3 texel(int column, int row) const { return glm::dvec3(glm::vec3(image->at(column, row))); }

    /// The index must be below 2^52 in absolute value: there the quotient's rounding reaches no whole number
    /// that it does not equal.
    static int inside(texture::Wrap wrap, std::int64_t index, int size) {
        if (index >= 0 && index < size) return int(index);
        if (wrap == texture::Wrap::clamp_to_edge) return index < 0 ? 0 : size - 1;
        const int period = wrap == texture::Wrap::repeat ? size : 2 * size;
        const int within = int(index - std::int64_t(std::floor(double(index) / period)) * period);
        return within < size ? within : period - 1 - within;
    }
};

/// Everything about a view's triangles that pixels ask for. The scene must outlive it.
class Surfaces {
  public:
    Surfaces(const Scene& scene, const View& view);
    Surfaces(const Surfaces&) = delete;
    Surfaces& operator=(const Surfaces&) = delete;

    std::uint32_t triangle_count() const { return std::uint32_t(seen_.size()); }
    /// The triangle in raster coordinates; nothing where it is seen edge-on.
    const std::optional<SeenTriangle<double>>& seen(std::uint32_t triangle) const { return seen_[triangle]; }
    int material(std::uint32_t triangle) const { return materials_[triangle]; }
    const SurfaceColour& colour(std::uint32_t triangle) const {
        return colours_[std::size_t(materials_[triangle])];
    }
    /// The largest absolute value that a texel with its factor shows; at least 1.
    double brightest() const { return brightest_; }
    /// Do both have two corners at the same places, float by float?
    bool share_an_edge(std::uint32_t a, std::uint32_t b) const;
    /// inverse depth is at most .nearest and at least .farthest between near and far.
    struct NearFarRange {
        double nearest, farthest;
    };
    const NearFarRange& range() const { return range_; }

  private:
    const Scene& scene_;
    std::vector<std::optional<SeenTriangle<double>>> seen_;
    std::vector<int> materials_;
    std::deque<texture::LinearImage> images_;
    std::vector<SurfaceColour> colours_;
    NearFarRange range_{};
    double brightest_ = 1;
};

/// Texel coordinates of a triangle's corners, exact in Number; zeros without a texture.
template <class Number>
CornerTexels<Number> corner_texels(const Scene& scene, const Material& material, const glm::uvec3& corners) {
    CornerTexels<Number> texels{};
    const Texture& t = material.base_color;
    if (t.image == Texture::none || std::size_t(t.uv_set) >= scene.vertices.uv.size()) return texels;
    const Image& image = scene.images[std::size_t(t.image)];
    for (glm::length_t i = 0; i < 3; ++i) {
        const glm::vec2 uv = scene.vertices.uv[std::size_t(t.uv_set)][corners[i]];
        const auto row = [&](glm::length_t r, int size) {
            return (Number(t.transform.translation[r]) +
                    Number(t.transform.linear[0][r]) * Number(double(uv.x)) +
                    Number(t.transform.linear[1][r]) * Number(double(uv.y))) *
                   Number(double(size));
        };
        texels[std::size_t(i)] = {row(0, image.width), row(1, image.height)};
    }
    return texels;
}

/// World-space corners, exact in Number.
template <class Number>
Triple<Number> corners_world(const Scene& scene, const glm::uvec3& corners) {
    const auto corner = [&](glm::length_t i) {
        return exactly<Number>(glm::dvec3(scene.vertices.position_world[corners[i]]));
    };
    return {corner(0), corner(1), corner(2)};
}

}  // namespace zproof::oracle::area
