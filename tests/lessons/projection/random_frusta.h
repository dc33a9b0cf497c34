/// Random views whose numbers are machine numbers, for exact arithmetic: the same ones every time.
#pragma once

#include <random>

#include "lessons/projection/camera.h"

namespace zproof::study::projection::test {

class RandomFrusta {
  public:
    explicit RandomFrusta(unsigned seed) : engine_(seed) {}

    double number(double low, double high) {
        return low + (high - low) * (double(engine_() >> 8) / double(1u << 24));
    }
    glm::dvec3 point(double reach) {
        const double x = number(-reach, reach), y = number(-reach, reach);
        return {x, y, number(-reach, reach)};
    }

    /// Off axis, turned any way; every fifth sees to infinity.
    View perspective() {
        View view = placed();
        Camera& c = view.camera;
        c.projection = Projection::perspective;
        c.near_depth = number(0.01, 2), c.far_depth = c.near_depth + number(0.5, 500);
        if (engine_() % 5 == 0) c.far_depth = std::numeric_limits<double>::infinity();
        return view;
    }
    /// Every second one is oblique.
    View parallel() {
        View view = placed();
        Camera& c = view.camera;
        c.projection = Projection::parallel;
        c.near_depth = number(-3, 2), c.far_depth = c.near_depth + number(0.5, 500);
        if (engine_() % 2 == 0) c.shear = {number(-1, 1), number(-1, 1)};
        return view;
    }

  private:
    View placed() {
        View view{.name = "random", .camera = look_at(point(5), point(5), {0.1, 1, 0.2})};
        view.camera.window.left = number(-2, 1), view.camera.window.bottom = number(-2, 1);
        view.camera.window.right = view.camera.window.left + number(0.1, 3);
        view.camera.window.top = view.camera.window.bottom + number(0.1, 3);
        view.width = 640, view.height = 480;
        return view;
    }

    std::mt19937 engine_;
};

inline Vector3<Rational> exact(const glm::dvec3& p) { return exactly<Rational>(p); }

}  // namespace zproof::study::projection::test
