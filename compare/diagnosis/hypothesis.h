/// One way in which a renderer may have gone wrong, put so that the judge can decide it (docs/diagnosis.md).
///
/// What the renderer answered at a pixel is read as its answer to the question that it would have been asked
/// if the hypothesis held: about another place, another view, in other units, or under another rule of
/// drawing. That answer is admissible or it is not, by the same rule and the same bounds as every other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/adjudicate/adjudicator.h"
#include "compare/judge.h"
#include "compare/labels/labelled_frame.h"
#include "frame/convention.h"

namespace zproof {

/// What a renderer says of one pixel.
struct Claim {
    int x = 0, y = 0;
    Answer answer;
    /// What it says itself where that is a label; its triangle stands for it.
    PrimitiveId label = PrimitiveId::none;
};

/// Does the claim speak of a pixel of an image of this size?
constexpr bool holds(Resolution size, const Claim& claim) {
    return claim.x >= 0 && claim.y >= 0 && claim.x < size.width && claim.y < size.height;
}

/// Numbers that a renderer may report for a depth; both ends belong to it.
struct ReportedDepth {
    double low = 0, high = 0;
};

/// What a hypothesis says, in words. No field has a default: one that is left out does not compile.
struct Cause {
    std::string name;         ///< what is wrong, as a clause: "the image is flipped in y"
    std::string description;  ///< one line: what is supposed of the defective pixels, or of the frame
    std::string look_at;      ///< where in a renderer's code to look first: one sentence
};

struct Hypothesis {
    Cause cause;
    /// Bits that it takes to tell what it learned from the two frames.
    double learned_bits = 0;
    bool fits_a_limit =
        false;  ///< Is what it learned one number, such as a limit that it fits to the frames?
    bool tells_numbers = false;  ///< Does the description tell the numbers that it fits to the frames?
    /// Does it read a claim by the pixels around? At outlines it may be mistaken.
    bool reads_surroundings = false;
    bool supposes_no_rule = false;  ///< Does it say what is missing, and not why?
    int kind = 0;                   ///< which of the catalogue's: rules of two kinds suppose different things
    /// Does it move triangles? Then it is no cause where every defect is a depth.
    bool moves_triangles = false;
    /// Does it say what may be wrong, and not what must? The right answer is admissible under it as well.
    bool only_permits = false;
    /// A grid of such cells, px: what is supposed befell those cells that hold a defect, whole. Pixels that
    /// agree in them must be admissible under the hypothesis, too.
    Resolution cell;
    View view;            ///< what was drawn; its depths are told apart by `report`
    Precision precision;  ///< and how precisely
    /// The claim as it was meant; nothing where the hypothesis cannot account for it. Absent: as it stands.
    std::function<std::optional<Claim>(const Claim&)> restate;
    /// Another rule of drawing. Absent: the declared rule.
    RuleOverride amend;
    /// What is reported where the depth lies within the bound. Absent: the depth.
    std::function<ReportedDepth(const DepthBound&, const Claim&)> report;
    /// Where `restate` decides by itself (decided_by): the depths that the claim, as it stands, may have.
    std::function<ReportedDepth(const Claim&)> decided_depth{};
    /// How many depths it can tell between two. Absent: every float32.
    std::function<double(const ReportedDepth&)> tellable{};
};

/// All that a diagnosis starts from.
struct DiagnosisInput {
    const Scene& scene;
    const View& view;
    const RenderedFrame& candidate;  ///< of triangles
    const RenderedFrame& reference;
    /// Where the candidate names no triangles: what it says. Its triangles stand for that, and under a
    /// hypothesis any triangle of the same label may.
    const SaidLabels* said = nullptr;
    /// What its depths were before they became camera depths.
    Convention convention{};
};

/// float32 values between both ends; at least 1.
double floats_within(const ReportedDepth& range);

/// Bits that name one triangle of the scene, or background; one label, where the candidate says labels.
double bits_of_an_id(const DiagnosisInput& input);

/// Bits of a number that is fitted to the frames.
inline constexpr double bits_of_a_number = 32;

/// The view whose image stands `step_px` (x right, y down) further than that of `view`.
View shifted_view(const View& view, const glm::dvec2& step_px);

/// Supposes nothing yet: the view as it is, drawn as precisely as declared.
Hypothesis as_declared(const DiagnosisInput& input, Cause cause);

}  // namespace zproof
