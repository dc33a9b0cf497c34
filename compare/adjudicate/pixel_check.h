/// Pixels that the first tier left undecided.
#pragma once

#include <functional>
#include <span>

#include "compare/adjudicate/adjudicator.h"
#include "compare/agree/agree.h"
#include "compare/rendered_frame.h"
#include "compare/verdict.h"

namespace zproof {

/// Whatever its bound is, no answer at all: NaN, an id out of range, background with a depth.
bool is_invalid(const Answer& answer, std::size_t triangle_count);

/// One renderer's answer at a pixel, by itself.
struct AnswerCheck {
    Answer answer;
    bool is_invalid = false;
    bool is_depth_admissible = true;  ///< so is one that there is none to ask about
    double error_over_bound = 0;      ///< of its depth; NaN where there is none to ask about
    bool is_depth_open = false;       ///< any depth is admissible
};

/// What is known of a pixel, answer by answer; decisions only where the id is undecided and the answer is
/// one.
struct PixelCheck {
    AnswerCheck candidate, reference;
    QueryResult candidate_decision{}, reference_decision{};
    std::optional<WrongAttribute> wrong_attribute{};  ///< of the candidate

    bool ids_differ() const { return candidate.answer.primitive != reference.answer.primitive; }
};

/// Does what is left to do at pixels that the first tier did not decide: tell(i, check) for each of them
/// once, on all threads. Depths that the first tier found admissible are not looked at.
void check_pixels(const FramePair& frames, std::span<const UndecidedPixel> pixels,
                  const std::function<void(std::size_t, const PixelCheck&)>& tell);

/// The class that it earns.
PixelClass class_of(const PixelCheck& pixel);
/// Is the reference's own answer inadmissible?
bool is_reference_wrong(const PixelCheck& pixel);
/// The evidence.
Finding finding_of(const FramePair& frames, const PixelCheck& pixel, const PixelCoord& place);

}  // namespace zproof
