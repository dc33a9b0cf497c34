/// A scene that no earlier run tells of.
#pragma once

#include "program/scene_selection.h"
#include "program/settings.h"
#include "reports/plan.h"

namespace zproof {

/// Its views, and what they are expected to take. It is read in a process of its own: where its reader
/// refuses, crashes or needs too much memory it is a scene without views, and its shard says why. To be
/// called before this process has any thread but one.
PlannedScene unknown_scene(const SceneSource& source, const RenderSettings& settings, double slowness);

}  // namespace zproof
