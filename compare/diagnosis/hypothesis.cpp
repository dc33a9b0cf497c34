#include "compare/diagnosis/hypothesis.h"

#include <utility>

namespace zproof {

Hypothesis as_declared(const CaseFile& file, std::string name, std::string description) {
    return {.name = std::move(name),
            .description = std::move(description),
            .kind = Kind::firm,
            .cell = {file.view.width, file.view.height},
            .view = file.view,
            .precision = file.candidate.precision,
            .restate = nullptr,
            .amend = nullptr,
            .report = nullptr};
}

}  // namespace zproof
