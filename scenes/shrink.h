/// Makes what fails smaller for as long as it fails: fewer triangles, fewer pixels, a plainer camera, shorter
/// numbers.
#pragma once

#include <functional>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

struct SceneAndView {
    Scene scene;
    View view;
};

/// Does it still fail in the way that matters? Asked only of what is judged (scenes/judged_ranges.h).
using StillFails = std::function<bool(const SceneAndView&)>;

struct ShrinkLimits {
    int most_tries = 1000;                                    ///< how often StillFails is asked
    std::function<bool()> is_stopped = [] { return false; };  ///< true: an answer that comes now is void
};

struct Shrunk {
    SceneAndView least;  ///< of positions, parts and materials; other attributes are gone
    int tries = 0;
};

/// `failing` fails. The same for the same answers; where it ends early, the least so far.
Shrunk shrink(const SceneAndView& failing, const StillFails& still_fails, const ShrinkLimits& limits = {});

}  // namespace zproof
