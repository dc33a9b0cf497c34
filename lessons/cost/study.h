/// The cost study: the lecture's model fitted to generated scenes, held against real ones, and the
/// optimizations that make its terms smaller.
#pragma once

#include "lessons/cost/experiments.h"
#include "lessons/cost/optimizations_study.h"

namespace zproof::study::cost {

/// The model and what it was fitted to.
struct Model {
    std::vector<Run> runs;
    Fit fit;
    /// Runs and fit of whole frames of meshes alone, as one would measure a program from outside: which
    /// constants such runs tell apart, and which only as a sum.
    std::vector<Run> whole_runs;
    Fit whole_fit;
};

/// A scene that took no part in the fit.
struct Prediction {
    std::string scene, view;
    Quantities quantities;
    Timing timing;
    double predicted = 0;       ///< ns
    std::vector<double> share;  ///< of the prediction, by constant
};

/// Announces each unit of work as it begins.
using Announce = std::function<void(const std::string& what)>;

/// `repeats` measured runs for each time.
Model fitted_model(int repeats, const Announce& announce);
int units_of_model();

Prediction predict(const Model& model, const Scene& scene, const View& view, int repeats);

}  // namespace zproof::study::cost
