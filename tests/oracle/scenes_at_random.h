/// Small scenes and cameras from a seed.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// Corners of the triangles, three by three, one vertex each.
Scene scene_of(const std::vector<glm::vec3>& corners);

/// Numbers that every standard library draws alike.
class Rng {
  public:
    explicit Rng(std::uint32_t seed) : engine_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * (static_cast<std::uint32_t>(engine_()) * 0x1p-32);
    }

  private:
    std::mt19937 engine_;
};

/// Triangles of all sizes, some of them through the camera's plane, around a point 6 units before the eye.
Scene random_soup(Rng& rng, const Camera& camera, int triangle_count);

/// Which of the four families of camera.
enum class ProjectionKind { perspective, off_axis, orthographic, oblique };

/// A camera somewhere, turned at random, near 2, far 9 (behind the eye in half of the parallel cases).
View random_view(Rng& rng, ProjectionKind projection_kind);

}  // namespace zproof::oracle
