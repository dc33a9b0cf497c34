/// Where a random scene is made: its view is drawn first, and triangles are placed in its image.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>

#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/random.h"
#include "scenes/view.h"

namespace zproof::random {

using suite::MeshBuilder;
using suite::Random;

/// A place in the image, and how far behind it: pixels and camera depth.
struct Place {
    glm::dvec2 raster{0.0};
    double depth = 1;
};
using Corners = std::array<Place, 3>;

class Stage {
  public:
    Stage(const View& view, Random& dice, MeshBuilder& mesh);

    const View& view() const { return view_; }
    Random& dice() { return dice_; }
    MeshBuilder& mesh() { return mesh_; }

    /// The point that is seen there, also for depths below 0; moved where its coordinates are not judged.
    glm::dvec3 world(const Place& place) const;
    /// The point, or the nearest one whose coordinates are judged.
    static glm::dvec3 judged(const glm::dvec3& p_world);
    /// In the image, or beside it by a quarter of its size.
    glm::dvec2 raster();
    /// Between near and far; not so near that float32 has few steps there.
    double depth();
    /// About as deep: within a share of it, and between near and far. Not much deeper than the view is wide:
    /// float32 does not know triangles that are seen almost edge-on.
    double depth_about(double depth, double share);
    Place place() {
        const glm::dvec2 at = raster();
        return {at, depth()};
    }
    /// True once in so many.
    bool once_in(int count) { return dice_.integer(1, count) == 1; }

    std::uint32_t vertex(const Place& place) { return mesh_.vertex(world(place)); }
    /// With vertices of its own.
    void triangle(const Corners& corners);
    void triangle(const std::array<glm::dvec3, 3>& p_world);

  private:
    const View& view_;
    Random& dice_;
    MeshBuilder& mesh_;
    double nearest_, farthest_;  ///< depths
};

}  // namespace zproof::random
