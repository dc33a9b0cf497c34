#include "tests/attack/trial.h"

#include <iomanip>
#include <sstream>

namespace zproof::attack {

namespace {

/// Places are rounded to 2^-20 px, depths to float32.
constexpr BoundedPrecision of_the_truth{.eps_px = 0x1p-20, .depth_relative = 0x1p-23};

}  // namespace

Trial::Trial(const AttackScene& scene)
    : scene_(scene),
      truth_(scene.scene, scene.view),
      right_(draw_at_limits(truth_, allowance_of(of_the_truth, scene.view), {})) {}

RenderedFrame Trial::reference() const { return {right_, of_the_truth}; }

Verdict Trial::judge_of(const Frame& frame, const Precision& precision) const {
    return judge(scene_.scene, scene_.view, {frame, precision}, reference());
}

std::string first_defect(const Verdict& verdict) {
    for (const Finding& f : verdict.findings) {
        if (!is_defect(f.verdict)) continue;
        std::ostringstream text;
        text << std::setprecision(9) << "(" << f.x << ", " << f.y << ") " << name_of(f.verdict)
             << ": triangle " << int(f.candidate.primitive) << " depth " << f.candidate.camera_depth
             << ", bound " << f.candidate_depth.low << " to " << f.candidate_depth.high << ", judged within "
             << f.eps_px << " px; the truth is " << int(f.reference.primitive) << " "
             << f.reference.camera_depth;
        return text.str();
    }
    return {};
}

}  // namespace zproof::attack
