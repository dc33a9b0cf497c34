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

std::string named(const Explanation& e) { return e.fitted.empty() ? e.name : e.name + ": " + e.fitted; }

namespace {

/// Does another cause explain and spare as much, so that the frame does not tell which it is?
bool is_alike(const Explanation& cause, const Explanation& other) {
    return cause.saved_share > 0 && other.saved_share > cause.saved_share - alike_shares &&
           explained_share(other) > explained_share(cause) - alike_shares;
}

/// "likely cause: A (explains ...); as good: B; of what it leaves: C (explains ...). Look at ..."
std::string cause_in_words(const Explanation& cause, const Diagnosis& d) {
    std::string text = "likely cause: " + named(cause) + " (explains " + extent_of(cause, d) + ")";
    if (!d.runners_up.empty() && is_alike(cause, d.runners_up.front()))
        text += "; as good: " + named(d.runners_up.front());
    for (const Explanation& further : d.further)
        text += "; of what it leaves: " + named(further) + " (explains " + percent(explained_share(further)) +
                ")";
    return cause.look_at.empty() ? text : text + ". " + cause.look_at;
}

}  // namespace

std::string in_words(const Diagnosis& d) {
    if (d.cause) return cause_in_words(*d.cause, d);
    if (d.runners_up.empty()) return "no cause is certain: no hypothesis explains the defects";
    const Explanation& best = d.runners_up.front();
    return "no cause is certain; at best, " + named(best) + " (would explain " + extent_of(best, d) + ")";
}

}  // namespace zproof
