#include "reports/results_diff.h"

#include <algorithm>
#include <iterator>

namespace zproof {

namespace {

std::size_t index_in(const Results& results, const ViewResult& wanted) {
    for (std::size_t i = 0; i < results.views.size(); ++i)
        if (results.views[i].scene == wanted.scene && results.views[i].view == wanted.view) return i;
    return results.views.size();
}

bool is_before(const DefectPixel& a, const DefectPixel& b) {
    return std::pair{a.y, a.x} < std::pair{b.y, b.x};
}

/// The defects of `some` at whose pixel there is none of `others`.
std::vector<DefectPixel> only_in(const std::vector<DefectPixel>& some,
                                 const std::vector<DefectPixel>& others) {
    std::vector<DefectPixel> rest;
    std::ranges::set_difference(some, others, std::back_inserter(rest), is_before);
    return rest;
}

ViewChange change_of(const RunToCompare& before, std::size_t i, const RunToCompare& after, std::size_t j) {
    ViewChange change{.scene = before.results.views[i].scene,
                      .view = before.results.views[i].view,
                      .before = &before.results.views[i],
                      .after = j < after.results.views.size() ? &after.results.views[j] : nullptr,
                      .appeared = std::nullopt,
                      .gone = std::nullopt};
    if (change.after == nullptr || !before.defects[i] || !after.defects[j]) return change;
    change.appeared = only_in(*after.defects[j], *before.defects[i]);
    change.gone = only_in(*before.defects[i], *after.defects[j]);
    return change;
}

}  // namespace

std::vector<DefectPixel> defects_among(const std::vector<Finding>& findings) {
    std::vector<DefectPixel> defects;
    for (const Finding& f : findings)
        if (is_defect(f.verdict)) defects.push_back({f.x, f.y, f.verdict});
    std::ranges::sort(defects, is_before);
    return defects;
}

std::vector<ViewChange> changes_between(const RunToCompare& before, const RunToCompare& after) {
    std::vector<ViewChange> changes;
    for (std::size_t i = 0; i < before.results.views.size(); ++i)
        changes.push_back(change_of(before, i, after, index_in(after.results, before.results.views[i])));
    for (const ViewResult& view : after.results.views)
        if (index_in(before.results, view) == before.results.views.size())
            changes.push_back({.scene = view.scene,
                               .view = view.view,
                               .before = nullptr,
                               .after = &view,
                               .appeared = std::nullopt,
                               .gone = std::nullopt});
    return changes;
}

bool is_worse(const ViewChange& c) {
    if (c.after == nullptr) return true;
    const bool is_proven = c.after->outcome == Outcome::proven;
    if (c.before == nullptr) return !is_proven;
    if (c.before->outcome == Outcome::proven && !is_proven) return true;
    // What was once judged and no longer is, is worse than any defect.
    if (was_judged(*c.before) && !was_judged(*c.after)) return true;
    if (!was_judged(*c.before)) return false;
    if (unwaived_defects(*c.after) > unwaived_defects(*c.before)) return true;
    return c.appeared && !c.appeared->empty() && unwaived_defects(*c.after) > 0;
}

bool is_any_different(const ViewChange& c) {
    if (c.before == nullptr || c.after == nullptr) return true;
    return c.before->outcome != c.after->outcome || c.before->counts != c.after->counts ||
           c.before->waived != c.after->waived || (c.appeared && !c.appeared->empty()) ||
           (c.gone && !c.gone->empty());
}

}  // namespace zproof
