#include "compare/diagnosis/hypothesis.h"

#include <utility>

namespace zproof {

Hypothesis as_declared(const DiagnosisInput& input, std::string name, std::string description) {
    return {.name = std::move(name),
            .description = std::move(description),
            .kind = Kind::firm,
            .cell = {input.view.width, input.view.height},
            .view = input.view,
            .precision = input.candidate.precision,
            .restate = nullptr,
            .amend = nullptr,
            .report = nullptr};
}

}  // namespace zproof
