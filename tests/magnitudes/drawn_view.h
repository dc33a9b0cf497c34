/// Scenes and views of all magnitudes that float32 and double have, from a seed.
#pragma once

#include <cstdint>
#include <random>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// Numbers that every standard library draws alike.
class Draw {
  public:
    explicit Draw(std::uint32_t seed) : engine_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (std::uint32_t(engine_()) * 0x1p-32);
    }
    bool one_in(unsigned n) { return engine_() % n == 0; }
    double sign() { return one_in(2) ? -1 : 1; }
    /// Every power of ten is as likely; one in eight is an end itself.
    double magnitude(double low, double high);

  private:
    std::mt19937 engine_;
};

struct DrawnView {
    Scene scene;
    View view;
};

/// Triangles before a camera, of which some lie near the pixels and others anywhere. One draw in four takes
/// whatever the numbers hold, the others keep near the judged ranges; either may lie outside of them.
DrawnView drawn_view(std::uint32_t seed);

}  // namespace zproof
