/// What is tried while a scene shrinks, and the least that failed so far.
#pragma once

#include "scenes/shrink.h"

namespace zproof::shrinking {

class Attempts {
  public:
    Attempts(SceneAndView failing, const StillFails& still_fails, const ShrinkLimits& limits)
        : least_(std::move(failing)), still_fails_(still_fails), limits_(limits) {}

    const SceneAndView& least() const { return least_; }
    int tries() const { return tries_; }
    int kept() const { return kept_; }  ///< how often something smaller failed
    bool are_over() const { return tries_ >= limits_.most_tries || limits_.is_stopped(); }

    /// Takes it for the least one if it still fails. What is not judged is not asked about.
    bool keep(SceneAndView smaller);

  private:
    SceneAndView least_;
    const StillFails& still_fails_;
    const ShrinkLimits& limits_;
    int tries_ = 0, kept_ = 0;
};

void drop_triangles(Attempts& attempts);
void crop_picture(Attempts& attempts);
void simplify_camera(Attempts& attempts);
void shorten_coordinates(Attempts& attempts);

}  // namespace zproof::shrinking
