/// How long a scene takes, before it is judged.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "program/scene_selection.h"
#include "program/settings.h"
#include "reports/plan.h"
#include "reports/results.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// What an earlier run tells of scenes: their views, and the seconds that they took.
class EarlierRun {
  public:
    EarlierRun() = default;  ///< there was none
    explicit EarlierRun(const Results& results);

    /// The scene as it was planned for, without shards. Nothing where the run did not judge all its views.
    std::optional<PlannedScene> scene(const std::string& name) const;

    /// How many times slower the judged views were than expected_of() says: 1 where nothing is known.
    double slowness() const { return slowness_; }

  private:
    std::map<std::string, PlannedScene> scenes_;
    double slowness_ = 1;
};

/// What a scene nobody has judged is expected to take: from its triangles and the pixels of its views, by
/// the model of docs/scale.md.
PlannedScene expected_of(const std::string& name, const Scene& scene, const std::vector<View>& views,
                         double slowness);

/// What a scene costs that has no view to judge: it cannot be read, or has no triangles.
PlannedScene expected_of_none(const std::string& name, double slowness);

/// Its views, and what they are expected to take. It is read in a process of its own: where its reader
/// refuses, crashes or needs too much memory it is a scene without views, and its shard says why. To be
/// called before this process has any thread but one.
PlannedScene unknown_scene(const SceneSource& source, const RenderSettings& settings, double slowness);

}  // namespace zproof
