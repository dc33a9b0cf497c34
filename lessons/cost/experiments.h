/// Generated scenes that vary one thing at a time, and what drawing them costs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/cost/fit.h"
#include "lessons/cost/lecture_pipeline.h"
#include "lessons/cost/timing.h"
#include "scenes/loaded.h"

namespace zproof::study::cost {

/// The lecture's quantities.
struct Quantities {
    double vertices = 0, triangles = 0;  ///< triangles: that are set up, not those that clipping left out
    double fragments = 0;                ///< d m^2: covered pixels, layer by layer
    double pixels = 0;                   ///< m^2
    double blocks = 0;  ///< of 4 x 4 pixels that triangles may cover: scanned whole for each of them
};

/// What a picture of this scene is made of; exact.
Quantities quantities_of(const Scene& scene, const View& view);

/// "vertices", and so on: the one quantity that an experiment varies.
struct Experiment {
    std::string varied;
    std::vector<double> levels;
    std::function<Loaded(double level)> scene;
    std::vector<Stages::Set> stages;  ///< each a run of its own at every level
};

/// Vertices: of which no triangle uses most. Triangles: each in a pixel whose centre it misses, so that it is
/// set up and covers nothing. Depth: layers over the whole image, the farthest first. Pixels: one layer.
std::vector<Experiment> experiments();

/// The constants, in the order of the factors: k_bus, k_xform, k_shade, k_setup, k_fragment, k_pixel, k_run.
/// The last two are not the lecture's: what a pixel costs that nothing covers (clearing, writing the frame),
/// and what a run costs that draws nothing.
std::vector<std::string> constant_names();
std::string constant_meaning(const std::string& name);

/// A measured run.
struct Run {
    std::string varied;
    Stages::Set stages = Stages::all;
    Quantities quantities;
    Timing timing;
};

/// What a run's time is the sum of, without the constants.
std::vector<double> factors_of(const Quantities& quantities, Stages::Set stages);

Run measured(const Loaded& loaded, Stages::Set stages, const std::string& varied, int repeats);

}  // namespace zproof::study::cost
