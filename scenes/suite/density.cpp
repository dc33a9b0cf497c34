#include <cmath>
#include <span>
#include <vector>

#include "math/widest.h"
#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"

namespace zproof::suite {

namespace {

double smooth(double t) { return t * t * (3 - 2 * t); }

double mix(double a, double b, double weight) { return a + (b - a) * weight; }

/// A coordinate among those of a lattice: whole part, and what smooth() makes of the rest.
struct LatticePlace {
    int whole;
    double weight;
};

LatticePlace lattice_place(double coordinate) {
    const double floor = std::floor(coordinate);
    return {static_cast<int>(floor), smooth(coordinate - floor)};
}

/// heights += amplitude * mix(upper, lower, weight).
void add_mixed(const double* upper, const double* lower, double weight, double amplitude,
               std::span<double> heights) {
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] += amplitude * (upper[i] + (lower[i] - upper[i]) * weight);
}

/// Value noise in [0, 1], smooth between random lattice values, over columns at some x and rows at any z
/// between two: along each line of the lattice it is interpolated once for all rows.
class Noise {
  public:
    Noise(std::span<const double> x, double low_z, double high_z, double frequency, std::uint64_t seed)
        : frequency_(frequency), first_line_(lattice_place(low_z * frequency).whole) {
        for (int line = first_line_; line <= lattice_place(high_z * frequency).whole + 1; ++line) {
            std::vector<double>& values = lines_.emplace_back();
            for (const double column : x) {
                const auto [whole, weight] = lattice_place(column * frequency);
                values.push_back(
                    mix(lattice_value(whole, line, seed), lattice_value(whole + 1, line, seed), weight));
            }
        }
    }

    /// Adds a row of the noise, times the amplitude.
    void add_to(std::span<double> heights, double z, double amplitude) const {
        const auto [whole, weight] = lattice_place(z * frequency_);
        const auto upper = static_cast<std::size_t>(whole - first_line_);
        widest<add_mixed>(lines_[upper].data(), lines_[upper + 1].data(), weight, amplitude, heights);
    }

  private:
    double frequency_;
    int first_line_;
    std::vector<std::vector<double>> lines_;  ///< a value for each column
};

/// Four octaves of noise over some columns: hills of about 12 units, ridges of about 1 unit.
class Terrain {
  public:
    Terrain(std::span<const double> x, double low_z, double high_z) {
        double frequency = 1.0 / 32;
        for (std::uint64_t octave = 0; octave < 4; ++octave, frequency *= 2.75)
            octaves_.emplace_back(x, low_z, high_z, frequency, octave);
    }

    std::vector<double> heights(double z, std::size_t columns) const {
        std::vector<double> sum(columns, 0.0);
        double amplitude = 12;
        for (const Noise& octave : octaves_) {
            octave.add_to(sum, z, amplitude);
            amplitude *= 0.4;
        }
        return sum;
    }

  private:
    std::vector<Noise> octaves_;
};

/// A random triangle around camera depth `depth`, about 64 px across at 1080 rows for half_height 0.3.
void add_shard(MeshBuilder& mesh, Random& random, ImageSize size) {
    const double depth = random.uniform(10, 40), margin = 1.05 * 0.3, half = 0.3 * depth * 0.06;
    const double u = random.uniform(-margin, margin) * size.aspect(), v = random.uniform(-margin, margin);
    const glm::dvec3 centre{u * depth, v * depth, -depth}, reach(half);
    const glm::dvec3 a = random.in_box(centre - reach, centre + reach);
    const glm::dvec3 b = random.in_box(centre - reach, centre + reach);
    const glm::dvec3 c = random.in_box(centre - reach, centre + reach);
    mesh.lone_triangle({a, b, c});
}

}  // namespace

Loaded million_triangles(ImageSize size) {
    MeshBuilder mesh("million_triangles");
    mesh.begin_part("terrain", {0.45, 0.5, 0.3});
    constexpr Cells cells{.across = 1000, .down = 500};
    std::vector<double> x;
    for (int column = 0; column <= cells.across; ++column)
        x.push_back(200 * (static_cast<double>(column) / cells.across) - 100);
    const Terrain terrain(x, -100, 0);
    add_sheet_by_rows(mesh, cells, [&](int row, std::span<glm::vec3> p_world) {
        const double z = 100 * (static_cast<double>(row) / cells.down) - 100;
        const std::vector<double> heights = terrain.heights(z, x.size());
        for (std::size_t i = 0; i < x.size(); ++i) p_world[i] = glm::dvec3{x[i], heights[i], z};
    });
    return mesh.finish(
        {perspective_view("oblique", size, {.eye_world = {8, 62, 36}, .target_world = {-3, 4, -46}},
                          {.half_height = 0.55, .near_depth = 1, .far_depth = 400}),
         perspective_view("grazing", size, {.eye_world = {-60, 21, 6}, .target_world = {40, 6, -90}},
                          {.half_height = 0.4, .near_depth = 0.25, .far_depth = 500})});
}

Loaded deep_overdraw(ImageSize size) {
    MeshBuilder mesh("deep_overdraw");
    Random random(4);
    for (int part = 0; part < 8; ++part) {
        mesh.begin_part("shards " + std::to_string(part), random.color());
        for (int i = 0; i < 25'000; ++i) add_shard(mesh, random, size);
    }
    return mesh.finish(
        {perspective_view("through", size, {}, {.half_height = 0.3, .near_depth = 1, .far_depth = 100}),
         perspective_view("aside", size, {.eye_world = {45, 6, -20}, .target_world = {0, 0, -24}},
                          {.half_height = 0.4, .near_depth = 1, .far_depth = 100})});
}

}  // namespace zproof::suite
