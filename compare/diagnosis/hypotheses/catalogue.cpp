#include "compare/diagnosis/hypotheses/catalogue.h"

#include <iterator>

#include "compare/diagnosis/hypotheses/look_at.h"

namespace zproof {

std::vector<Hypothesis> all_hypotheses(const DiagnosisInput& input) {
    std::vector<Hypothesis> all;
    for (const auto family :
         {hypotheses_of_signs, hypotheses_of_place, hypotheses_of_grid, hypotheses_of_depth,
          hypotheses_of_depth_elsewhere, hypotheses_of_ids, hypotheses_of_shared_ids,
          hypotheses_of_dropped_triangles, hypotheses_of_drawing, hypotheses_of_coverage, hypotheses_of_parts,
          hypotheses_of_window, hypotheses_of_precision}) {
        std::vector<Hypothesis> more = family(input);
        all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    for (Hypothesis& h : all) h.look_at = look_at(h.name);
    return all;
}

}  // namespace zproof
