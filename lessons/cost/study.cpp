#include "lessons/cost/study.h"

#include <cmath>

#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/views.h"

namespace zproof::study::cost {
namespace {

Fit fit_of(const std::vector<Run>& runs) {
    std::vector<Observation> rows;
    for (const Run& run : runs) rows.push_back({factors_of(run.quantities, run.stages), run.timing.median});
    return fitted(rows);
}

/// Meshes of two triangles a vertex, as meshes are, at three sizes of image.
Loaded sheet(double cells, int side_px) {
    suite::MeshBuilder mesh("sheet");
    mesh.begin_part("sheet", {1, 1, 1});
    suite::add_sheet(mesh, {.across = int(cells), .down = int(cells)}, [](double s, double t) {
        return glm::dvec3{2 * s - 1, 2 * t - 1, -2 - 0.1 * s * t};
    });
    return mesh.finish({suite::perspective_view("ahead", {side_px, side_px}, {},
                                                {.half_height = 0.45, .near_depth = 0.5, .far_depth = 10})});
}

std::vector<Run> whole_runs(int repeats) {
    std::vector<Run> runs;
    for (const int side_px : {256, 512, 1024})
        for (const double cells : {20.0, 60.0, 180.0, 400.0})
            runs.push_back(measured(sheet(cells, side_px), Stages::all, "whole frames", repeats));
    return runs;
}

}  // namespace

int units_of_model() { return int(experiments().size()) + 1; }

Model fitted_model(int repeats, const Announce& announce) {
    Model model;
    for (const Experiment& experiment : experiments()) {
        announce(experiment.varied);
        for (const double level : experiment.levels) {
            const Loaded loaded = experiment.scene(level);
            for (const Stages::Set stages : experiment.stages)
                model.runs.push_back(measured(loaded, stages, experiment.varied, repeats));
        }
    }
    model.fit = fit_of(model.runs);
    announce("whole frames");
    model.whole_runs = whole_runs(repeats);
    model.whole_fit = fit_of(model.whole_runs);
    return model;
}

Prediction predict(const Model& model, const Scene& scene, const View& view, int repeats) {
    Prediction prediction{scene.name, view.name, quantities_of(scene, view), {}, 0, {}};
    LecturePipeline pipeline(scene, view);
    prediction.timing = timed(repeats, [&] { pipeline.run(Stages::all); });
    const std::vector<double> factors = factors_of(prediction.quantities, Stages::all);
    prediction.predicted = predicted(model.fit.constant, factors);
    for (std::size_t i = 0; i < factors.size(); ++i)
        prediction.share.push_back(model.fit.constant[i] * factors[i] / prediction.predicted);
    return prediction;
}

}  // namespace zproof::study::cost
