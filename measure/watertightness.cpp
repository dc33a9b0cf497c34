#include <algorithm>

#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

constexpr int image_side = 128;  ///< of the image, px

/// A triangle and its colour. Triangles of one colour do not touch, so that a picture of them alone shows
/// every one of their fragments.
struct ColouredTriangle {
    RasterTriangle corners;
    std::size_t colour = 0;
};
using Mesh = std::vector<ColouredTriangle>;

/// Always the same numbers, 0 to below n (Knuth's multiplicative hash).
int scattered(int i, int j, int n) {
    const std::uint32_t seed = std::uint32_t(i) * 2654435761u + std::uint32_t(j) * 2246822519u;
    return int(((seed ^ (seed >> 15)) * 2654435761u >> 8) % std::uint32_t(n));
}

/// A sheet of 8 px cells whose corners are moved by quarters of a pixel, so that many edges run through
/// samples. Moved by less than 2 px, no triangle turns over: (8 - 2 m)^2 > (2 m)^2.
Mesh moved_sheet(const Sample& sample) {
    constexpr int cell = 8, cells = image_side / cell + 2;
    const auto corner = [&](int i, int j) {
        const double dx = (scattered(i, j, 15) - 7) / 4.0, dy = (scattered(j + 999, i, 15) - 7) / 4.0;
        return RasterPoint{cell * (i - 1) + sample.x + dx, cell * (j - 1) + sample.y + dy};
    };
    Mesh mesh;
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const auto a = corner(i, j), b = corner(i + 1, j), c = corner(i, j + 1), d = corner(i + 1, j + 1);
            const std::size_t colour = 2 * std::size_t(i % 2) + 4 * std::size_t(j % 2);
            mesh.push_back({{a, b, c}, colour});
            mesh.push_back({{b, d, c}, colour + 1});
        }
    }
    return mesh;
}

/// Squares of 16 px, each a fan around a sample, with rim points 2 px apart on samples: every slope.
Mesh fans(const Sample& sample) {
    constexpr int cell = 16, cells = image_side / cell + 2, spokes = 32;
    const auto rim = [](int k) {
        const int along = 2 * (k % 8), turn = k / 8 % 4;
        const glm::ivec2 corner[] = {{along, 0}, {cell, along}, {cell - along, cell}, {0, cell - along}};
        return corner[turn];
    };
    Mesh mesh;
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const double x = cell * (i - 1) + sample.x, y = cell * (j - 1) + sample.y;
            const RasterPoint hub{x + 3 + scattered(i, j, 11), y + 3 + scattered(j, i + 99, 11)};
            for (int k = 0; k < spokes; ++k) {
                const glm::ivec2 a = rim(k), b = rim(k + 1);
                mesh.push_back({{{hub, {x + a.x, y + a.y}, {x + b.x, y + b.y}}}, std::size_t(k)});
            }
        }
    }
    return mesh;
}

template <class Wanted>
Frame picture(const Renderer& renderer, const Mesh& mesh, Wanted wanted) {
    Scene scene;
    for (const ColouredTriangle& triangle : mesh) {
        if (wanted(triangle)) add_triangle(scene, Axis::x, triangle.corners);
    }
    return renderer.render(scene, raster_view(image_side, image_side));
}

void add_flaws(Watertightness& sum, const Renderer& renderer, const Mesh& mesh) {
    const std::size_t colours = std::ranges::max(mesh, {}, &ColouredTriangle::colour).colour + 1;
    Plane<std::uint32_t> hits({image_side, image_side});
    for (std::size_t colour = 0; colour < colours; ++colour) {
        const Frame frame =
            picture(renderer, mesh, [=](const ColouredTriangle& t) { return t.colour == colour; });
        for (std::size_t i = 0; i < hits.pixels().size(); ++i)
            hits.pixels()[i] += frame.primitive.pixels()[i] != PrimitiveId::none;
    }
    const Frame whole = picture(renderer, mesh, [](const ColouredTriangle&) { return true; });
    for (std::size_t i = 0; i < hits.pixels().size(); ++i) {
        const std::uint32_t hit = hits.pixels()[i];
        ++sum.pixels;
        sum.holes += hit == 0 || whole.primitive.pixels()[i] == PrimitiveId::none;
        sum.double_hits += hit > 1 ? hit - 1 : 0;
    }
}

}  // namespace

Watertightness watertightness(const Renderer& renderer, const Sample& sample) {
    Watertightness sum;
    add_flaws(sum, renderer, moved_sheet(sample));
    add_flaws(sum, renderer, fans(sample));
    return sum;
}

}  // namespace zproof::measure
