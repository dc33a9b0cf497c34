#include "compare/diagnosis/hypothesis.h"

#include <cmath>
#include <utility>

namespace zproof {

Hypothesis as_declared(const DiagnosisInput& input, std::string name, std::string description) {
    return {.name = std::move(name),
            .description = std::move(description),
            .cell = {input.view.width, input.view.height},
            .view = input.view,
            .precision = input.candidate.precision,
            .restate = nullptr,
            .amend = nullptr,
            .report = nullptr};
}

double bits_of_an_id(const Scene& scene) { return std::log2(double(scene.triangles.size()) + 1); }

}  // namespace zproof
