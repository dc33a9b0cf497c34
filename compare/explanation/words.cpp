#include <algorithm>
#include <cmath>
#include <sstream>

#include "compare/explanation/explain.h"

#include "frame/number_text.h"

namespace zproof {

namespace {

std::string number(double value, int digits) {
    return std::isnan(value) ? "not a number" : with_digits(value, digits);
}

std::string name_of(PrimitiveId primitive) {
    return primitive == PrimitiveId::none ? "background"
                                          : "triangle " + std::to_string(std::uint32_t(primitive));
}

/// "triangle 17 (node Wheel, mesh Spokes)".
std::string full_name_of(const Scene& scene, PrimitiveId primitive) {
    const auto holds = [&](const Part& part) {
        return std::uint32_t(primitive) - part.first_triangle < part.triangle_count;
    };
    const auto part = std::ranges::find_if(scene.parts, holds);
    if (primitive == PrimitiveId::none || part == scene.parts.end()) return name_of(primitive);
    return name_of(primitive) + " (node " + (part->node.empty() ? "unnamed" : part->node) + ", mesh " +
           (part->mesh.empty() ? "unnamed" : part->mesh) + ")";
}

/// " (error/bound 1.25)"; nothing where there is no ratio, as of a depth that is not a number.
std::string ratio(double error_over_bound) {
    return std::isnan(error_over_bound) ? "" : " (error/bound " + number(error_over_bound, 3) + ")";
}

std::string depth_sentence(const Finding& f) {
    return "depth " + number(f.candidate.camera_depth, 9) + ", admissible from " +
           number(f.candidate_depth.low, 9) + " to " + number(f.candidate_depth.high, 9) +
           ratio(f.error_over_bound);
}

std::string attribute_sentence(const WrongAttribute& wrong) {
    return std::string(attribute_channels[wrong.channel].name) + " is " + number(wrong.value, 9) +
           ", admissible from " + number(wrong.low, 9) + " to " + number(wrong.high, 9) +
           ratio(wrong.error_over_bound);
}

std::string reason(const Finding& f) {
    const std::string square = "within " + number(f.eps_px, 4) + " px";
    switch (f.verdict) {
        case PixelClass::agree:
            return "same id, depth within its bound";
        case PixelClass::edge:
            return "both are visible " + square + " of the centre: they meet at an edge";
        case PixelClass::depth_tie:
            return "both are visible " + square + ", but one only because the depths tie within their bounds";
        case PixelClass::abutting_edges:
            return "visible only through a crack: occluders abut " + square + " without sharing an edge";
        case PixelClass::clip:
            return "both are admissible " + square + ": the near or far plane cuts there";
        case PixelClass::reference_wrong:
            return "the candidate is admissible " + square + ", the reference is not";
        case PixelClass::undecidable:
            return "undecidable at eps = " + number(f.eps_px, 4) +
                   " px: too many triangles may be shown there";
        case PixelClass::wrong_attribute:
            return "id and depth are right, an attribute is not: " +
                   (f.wrong_attribute ? attribute_sentence(*f.wrong_attribute) : "");
        case PixelClass::wrong_depth:
            return "the id is right, the depth is not: " + depth_sentence(f);
        case PixelClass::hole:
            return "the square of " + number(f.eps_px, 4) + " px around the centre is covered for certain";
        case PixelClass::outside:
            return "its triangle does not come " + square + " of the centre";
        case PixelClass::hidden:
            return "it is occluded for certain everywhere " + square + " of the centre";
        case PixelClass::invalid:
            return "that is no answer: depth " + number(f.candidate.camera_depth, 9);
    }
    return {};
}

const char* words_for(Admissibility s) {
    switch (s) {
        case Admissibility::visible:
            return "admissible: visible";
        case Admissibility::clipped:
            return "admissible: visible, at a clip plane";
        case Admissibility::tied:
            return "admissible: within the depth bounds of the nearest";
        case Admissibility::through_a_crack:
            return "admissible only through a crack of the scene";
        case Admissibility::undecidable:
            return "undecidable: too many triangles within eps";
        case Admissibility::hole:
            return "not admissible: covered for certain";
        case Admissibility::outside:
            return "not admissible: does not reach the square";
        case Admissibility::hidden:
            return "not admissible: occluded for certain";
    }
    return "";
}

void tell(std::ostream& text, const Scene& scene, const Candidate& c) {
    text << "  " << full_name_of(scene, c.primitive) << "\n      edges";
    for (const double distance : c.edge_distance)
        text << ' ' << (std::isnan(distance) ? "-" : number(distance, 5));
    text << "  (1/256 px, inside > 0)\n      depth " << number(c.depth.truth, 12) << ", admissible "
         << number(c.depth.low, 12) << " to " << number(c.depth.high, 12) << "\n      "
         << words_for(c.decision.admissibility) << (c.decision.exact ? "  [exact rationals]" : "") << '\n';
}

/// "  candidate  triangle 17, depth 3.25; eps 0.002 px = 0.5/256 px; admissible: visible".
void tell(std::ostream& text, const char* who, const Answer& answer, const char* admissibility,
          double eps_px) {
    text << "  " << who << "  " << name_of(answer.primitive) << ", depth " << number(answer.camera_depth, 9)
         << "; eps " << number(eps_px, 4) << " px = " << number(256 * eps_px, 4) << "/256 px"
         << (*admissibility ? "; " : "") << admissibility << '\n';
}

}  // namespace

std::string in_words(const Scene& scene, const Finding& f) {
    return "candidate says " + full_name_of(scene, f.candidate.primitive) + ", reference " +
           full_name_of(scene, f.reference.primitive) + ": " + reason(f);
}

std::string in_words(const Scene& scene, const PixelExplanation& explanation) {
    const Finding& f = explanation.finding;
    std::ostringstream text;
    text << "pixel (" << f.x << ", " << f.y << "): " << name_of(f.verdict)
         << (passes(f.verdict) ? ", pass" : ", FAIL") << "\n  " << in_words(scene, f) << '\n';
    const bool decided = explanation.ids_differ && f.verdict != PixelClass::invalid;
    tell(text, "candidate", f.candidate, decided ? words_for(explanation.candidate.admissibility) : "",
         f.eps_px);
    tell(text, "reference", f.reference, decided ? words_for(explanation.reference.admissibility) : "",
         decided ? explanation.reference.eps_px : f.eps_px);
    text << "triangles within the candidate's eps of the centre, nearest first:\n";
    for (const Candidate& c : explanation.candidates) tell(text, scene, c);
    if (explanation.left_out > 0)
        text << "  not asked about: " << explanation.left_out << " farther triangles around, since the work "
             << "that an explanation is given was spent\n";
    else if (explanation.candidates.empty())
        text << "  none\n";
    text << "background: " << words_for(explanation.background.admissibility) << '\n';
    return text.str();
}

}  // namespace zproof
