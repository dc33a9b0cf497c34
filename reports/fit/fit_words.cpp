#include "reports/fit/fit_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/wording.h"

namespace zproof {
namespace {

using measure::LeftOut;
using measure::ViewFit;
using Reason = LeftOut::Reason;

constexpr std::size_t most_places = 5;

std::vector<PixelCoord> places_of(const ViewFit& fit, Reason reason) {
    std::vector<PixelCoord> places;
    for (const LeftOut& l : fit.left_out)
        if (l.reason == reason) places.push_back(l.pixel);
    return places;
}

std::string look_at(const std::vector<PixelCoord>& places) {
    std::string text = "look at ";
    for (std::size_t i = 0; i < std::min(places.size(), most_places); ++i)
        text +=
            (i == 0 ? "(" : ", (") + std::to_string(places[i].x) + ", " + std::to_string(places[i].y) + ")";
    return places.size() > most_places ? text + ", ..." : text;
}

/// "; 3 pixels MIDDLE: look at (12, 7)"; empty where there is none.
std::string remark(const ViewFit& fit, Reason reason, const std::string& middle) {
    const std::vector<PixelCoord> places = places_of(fit, reason);
    if (places.empty()) return "";
    return "; " + counted(places.size(), "pixel") + " " + middle + ": " + look_at(places);
}

std::string most_px() { return rounded(std::ldexp(1.0, measure::most_octave)) + " px"; }

}  // namespace

std::string_view name_of(Reason reason) {
    switch (reason) {
        case Reason::alone_by_place:
            return "alone_by_place";
        case Reason::alone_by_depth:
            return "alone_by_depth";
        case Reason::beyond_all_places:
            return "beyond_all_places";
        case Reason::beyond_all_depths:
            return "beyond_all_depths";
        case Reason::no_answer:
            return "no_answer";
    }
    return "no_answer";
}

std::string fit_in_words(const ViewFit& fit) {
    const std::vector<PixelCoord> alone = places_of(fit, Reason::alone_by_place);
    std::string text = "eps " + rounded(fit.eps.found_px()) + " px explains ";
    if (fit.left_out.empty()) return text + "every pixel";
    if (alone.empty())
        text += "every other pixel";
    else
        text += "all but " + counted(alone.size(), "pixel") + "; those need " +
                rounded(fit.eps_of_alone.found_px()) + " px: " + look_at(alone);
    return text +
           remark(fit, Reason::alone_by_depth,
                  "with a depth error of " + rounded(fit.depth_of_alone.error.relative) +
                      ", far above all others") +
           remark(fit, Reason::beyond_all_places, "that no eps up to " + most_px() + " explains") +
           remark(fit, Reason::beyond_all_depths, "at a depth that no error explains") +
           remark(fit, Reason::no_answer, "without an answer");
}

}  // namespace zproof
