/// What is frozen: two frames of a view, and what their renderers promise.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::frozen {

/// One pair of frames for the judge.
struct Case {
    std::shared_ptr<const Scene> scene;
    View view;
    Frame candidate, reference;
    Precision candidate_precision, reference_precision;
};

/// What has a line of its own in frozen.txt.
struct Subject {
    std::string group, name;
    std::vector<Case> cases;  ///< at least one
};

}  // namespace zproof::frozen
