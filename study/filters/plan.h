/// What a study does with a scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/metrics/picture_metric.h"
#include "frame/picture.h"
#include "oracle/area_integral.h"
#include "rasterizer/texturing.h"
#include "study/filters/evidence.h"

namespace zproof::study {

/// A method with its settings, as somebody asked for it.
struct ConfiguredMethod {
    std::string label;  ///< unique within a plan
    rasterizer::Texturing texturing;
    /// Draws the textures of a frame in place of rasterizer::filtered: a sampler of others. Empty: none does.
    std::function<Picture(const Scene&, const View&, const Frame&)> paint{};
};

struct Plan {
    std::vector<ConfiguredMethod> methods;
    oracle::Reconstruction truth = oracle::Reconstruction::bilinear;
    int flicker_steps = 2;  ///< further views, each shifted by flicker_step_px; 0: flicker is not measured
    /// Rows above it count in the regions "all" and "horizon" only, and cost nothing: where a plane ends in
    /// its horizon, a few rows would decide everything.
    int first_row = 0;
};

/// The step from view to view of the flicker measure, pixels: neither a round fraction nor along an axis.
inline constexpr double flicker_step_x_px = 0.37, flicker_step_y_px = 0.23;

/// Follows a study.
struct ProgressSink {
    std::function<void(const std::string& what)> begins;  ///< "truth", "trilinear-gl"; then a unit is done
    std::function<void(const std::string& name, const Picture&)> is_shown;  ///< "truth", or a label
    std::function<bool()> wants_to_stop;
    /// Before the first method; empty: not asked for.
    std::function<void(const ViewEvidence&)> is_known{};
    /// A metric's value at every pixel, of a method that was shown; empty: not asked for.
    std::function<void(const std::string& label, const PictureMetric&, const Plane<double>& map)> is_mapped{};
};

/// Units of work of one view, each announced by ProgressSink::begins.
inline int units_of(const Plan& plan) { return 1 + int(plan.methods.size()); }

}  // namespace zproof::study
