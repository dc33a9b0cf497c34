#include "reports/diagnosis_words.h"

#include <cmath>

#include "reports/wording.h"

namespace zproof {

std::string percent(double share) {
    return share >= 1 ? "100%" : fixed(std::floor(share * 1000) / 10, 1) + "%";
}

std::string extent_of(const Explanation& e, const Diagnosis& d) {
    const std::string share = percent(explained_share(e)) + " of ";
    if (e.asked == d.defects) return share + counted(d.defects, "defect");
    return share + counted(e.asked, "defect") + " tried, of " + grouped(d.defects) + " in all";
}

std::string in_words(const Diagnosis& d) {
    if (d.cause) return "likely cause: " + d.cause->name + " (explains " + extent_of(*d.cause, d) + ")";
    if (d.runners_up.empty()) return "no single cause: no hypothesis explains the defects";
    const Explanation& best = d.runners_up.front();
    return "no single cause; at best, " + best.name + " (would explain " + extent_of(best, d) + ")";
}

}  // namespace zproof
