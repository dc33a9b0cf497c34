/// The fixtures that faults are injected into: a suite scene, rendered and traced.
#pragma once

#include <string>
#include <vector>

#include "frame/plane.h"
#include "scenes/loaded.h"
#include "selftest/fault.h"

namespace zproof::selftest {

/// The suite scene of the selftest: surfaces seen from both sides, several deep, before background.
inline constexpr const char* fixture_scene = "back_faces";

Resolution resolution_of(FixtureSize size);

/// The first view of the fixture's scene with its two frames.
class TestScene {
  public:
    /// Renders and traces on the threads of the surrounding tbb::task_arena.
    explicit TestScene(FixtureSize size);
    TestScene(const TestScene&) = delete;  // fixture() points into this object
    TestScene& operator=(const TestScene&) = delete;

    Fixture fixture() const;

  private:
    Loaded loaded_;
    Frame good_, reference_;
};

}  // namespace zproof::selftest
