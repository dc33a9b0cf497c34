/// The stages that faults are injected into: a suite scene, rendered and traced.
#pragma once

#include <string>
#include <vector>

#include "cli/selftest/fault.h"
#include "frame/plane.h"
#include "scenes/loaded.h"

namespace zproof::selftest {

/// The suite scene of the selftest: surfaces seen from both sides, several deep, before background.
inline constexpr const char* stage_scene = "back_faces";

Resolution resolution_of(StageSize size);

/// The first view of the stage's scene with its two frames.
class Theatre {
  public:
    /// Renders and traces on the threads of the surrounding tbb::task_arena.
    explicit Theatre(StageSize size);
    Theatre(const Theatre&) = delete;  // stage() points into this object
    Theatre& operator=(const Theatre&) = delete;

    Stage stage() const;

  private:
    Loaded loaded_;
    Frame good_, reference_;
};

}  // namespace zproof::selftest
