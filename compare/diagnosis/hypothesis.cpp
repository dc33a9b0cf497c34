#include "compare/diagnosis/hypothesis.h"

#include <iterator>

#include "compare/diagnosis/hypotheses/catalogue.h"

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

std::vector<Hypothesis> all_hypotheses(const CaseFile& file) {
    std::vector<Hypothesis> all;
    for (const auto family :
         {hypotheses_of_signs, hypotheses_of_place, hypotheses_of_depth, hypotheses_of_ids,
          hypotheses_of_drawing, hypotheses_of_parts, hypotheses_of_precision}) {
        std::vector<Hypothesis> more = family(file);
        all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return all;
}

}  // namespace zproof
