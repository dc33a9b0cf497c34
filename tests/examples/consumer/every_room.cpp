// Calls something out of every room that is installed, so that each must be found, compiled against and
// linked.
#include <iostream>

#include "compare/judge.h"
#include "filters/methods/catalogue.h"
#include "filters/study/study.h"
#include "math/rounding.h"
#include "measure/measure.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "reports/json.h"
#include "reports/results.h"
#include "scenes/suite.h"

int main() {
    using namespace zproof;
    const Loaded room = generate_suite_scene("room", 64, 40);
    const View& view = room.views.at(0);
    const Frame ours = rasterizer::render(room.scene, view), theirs = oracle::Embree{room.scene}.trace(view);
    const Verdict verdict =
        judge(room.scene, view, {ours, rasterizer::precision()}, {theirs, oracle::embree_precision()});
    const std::string results = to_json(Results{});
    const study::StudyResults cards = study::begun({.methods = {}});
    const auto findings = measure::findings(measure::Measurement{}, Precision{RasterPrecision{}});
    std::cout << verdict.classes.size().width << " " << cards.metrics.size() << " "
              << texture::methods().size() << " " << findings.size() << " " << gamma(3, unit_roundoff_float32)
              << "\n";
    return findings.empty() && results_from_json(results).views.empty() ? 0 : 1;
}
