/// What a study does with a scene.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "filters/area/area_integral.h"
#include "filters/metrics/picture_metric.h"
#include "filters/study/evidence.h"
#include "frame/picture.h"
#include "rasterizer/texturing.h"

namespace zproof::study {

/// A picture that somebody else's renderer should have drawn and did not. The study goes on without it.
struct RendererFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A method with its settings, as somebody asked for it.
struct StudyMethod {
    std::string label;  ///< unique within a plan
    rasterizer::Texturing texturing;
    /// Draws the textures of a frame in place of rasterizer::filtered: a sampler or a renderer of others.
    /// Empty: none does. May throw RendererFailure.
    std::function<Picture(const Scene&, const View&, const Frame&)> paint{};
    /// A still has the view itself alone: its flicker is not measured.
    enum class Views { panned, still } views = Views::panned;
};

struct Plan {
    std::vector<StudyMethod> methods;
    oracle::Reconstruction truth = oracle::Reconstruction::bilinear;
    LightRange light = LightRange::up_to_white;  ///< which metrics are measured
    int flicker_steps = 2;  ///< further views, each shifted by flicker_step_px; 0: flicker is not measured
    /// Rows above it count in the regions "all" and "horizon" only, and cost nothing: where a plane ends in
    /// its horizon, a few rows would decide everything.
    int first_row = 0;
};

/// The step from view to view of the flicker measure, pixels: neither a round fraction nor along an axis.
inline constexpr double flicker_step_x_px = 0.37, flicker_step_y_px = 0.23;

/// Follows a study.
struct ProgressSink {
    /// "truth", "trilinear-gl", with its part of work_of(); then the piece before it is done.
    std::function<void(const std::string& what, double work)> begins;
    std::function<void(const std::string& name, const Picture&)> is_shown;  ///< "truth", or a label
    std::function<bool()> wants_to_stop;
    /// Before the first method; empty: not asked for.
    std::function<void(const ViewEvidence&)> is_known{};
    /// A metric's value at every pixel, of a method that was shown; empty: not asked for.
    std::function<void(const std::string& label, const PictureMetric&, const Plane<double>& map)> is_mapped{};
};

/// The work on one view's truths is about that on all its methods together.
inline double work_of_truths(const Plan& plan) { return double(plan.methods.size()); }
/// All work on one view, 1 for each method.
inline double work_of(const Plan& plan) { return work_of_truths(plan) + double(plan.methods.size()); }

}  // namespace zproof::study
