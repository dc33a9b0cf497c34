/// Frames before the judge, as the attack brings them.
#pragma once

#include "compare/judge.h"
#include "tests/attack/attack_scenes.h"
#include "tests/attack/limit_renderer.h"

namespace zproof::attack {

/// A scene with what is true of it, and a frame that shows just that.
class Trial {
  public:
    explicit Trial(const AttackScene& scene);

    const AttackScene& scene() const { return scene_; }
    const ExactScene& truth() const { return truth_; }
    const Frame& right() const { return right_; }
    RenderedFrame reference() const;

    Verdict judge_of(const Frame& frame, const Precision& precision) const;

  private:
    const AttackScene& scene_;
    ExactScene truth_;
    Frame right_;
};

/// What an honest renderer was accused of: the first pixel with its words, empty where there is none.
std::string first_defect(const Verdict& verdict);

}  // namespace zproof::attack
