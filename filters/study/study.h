/// Texture filters held to the exact area integral: how far off, where, and at what cost.
#pragma once

#include "filters/study/plan.h"
#include "filters/study/results.h"
#include "scenes/loaded.h"

namespace zproof::study {

/// What stands before any view is studied: the cards of metrics, regions and methods.
StudyResults begun(const Plan& plan);

/// Draws the view with every configured method and scores it. Each pixel shows the surface that its centre
/// sees in exact geometry; none is mixed with its neighbours, so silhouettes count against all methods (see
/// the region "interior"). Ends early, with the methods done so far, where the progress sink wants to stop.
/// On the threads of the surrounding tbb::task_arena; all but the times in Cost and truth_seconds is the same
/// for any number of them. Throws OracleError.
ViewStudy study_view(const Scene& scene, const View& view, const Plan& plan,
                     const ProgressSink& progress_sink);

/// The view with its image plane moved, so that what was seen at (x, y) is seen at (x - dx, y - dy).
View shifted(const View& view, double dx_px, double dy_px);

}  // namespace zproof::study
