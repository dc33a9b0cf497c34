/// What a scene file, a view file or the suite's generator gives: a scene and the views to judge it from.
#pragma once

#include <vector>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

struct Loaded {
    Scene scene;
    std::vector<View> views;  ///< at least one
};

}  // namespace zproof
