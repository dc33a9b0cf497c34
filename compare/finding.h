/// A pixel at which two frames do not simply agree, with the evidence.
#pragma once

#include <optional>
#include <string_view>
#include <tuple>

#include "compare/attributes/wrong_attribute.h"
#include "compare/bounds/depth_bound.h"
#include "compare/pixel_class.h"
#include "frame/field.h"
#include "frame/frame.h"

namespace zproof {

/// One renderer's answer at one pixel.
struct Answer {
    PrimitiveId primitive = PrimitiveId::none;
    float camera_depth = background_depth;
};

/// A pixel at which the two frames do not simply agree, with the evidence.
struct Finding {
    int x = 0, y = 0;
    PixelClass verdict = PixelClass::agree;
    Answer candidate, reference;
    double eps_px = 0;            ///< half-side of the square that the candidate's answer was judged in
    DepthBound candidate_depth;   ///< bound for the candidate's own id
    double error_over_bound = 0;  ///< of the candidate's depth; NaN for background
    std::optional<WrongAttribute> wrong_attribute{};  ///< of the candidate; where the verdict says so
};

/// The form of a float's bits.
struct Bits;

inline constexpr std::string_view scene_units = "scene units", the_bits = "the float32's bits";

/// In the order of results.json and of findings.csv. Bits stand behind the decimal, so that a reader keeps
/// them.
template <>
inline constexpr auto fields<Finding> = std::tuple{
    field("x", &Finding::x, "column; 0 is the left one", {.unit = "px"}),
    field("y", &Finding::y, "0 is the top row", {.unit = "px"}),
    field("class", &Finding::verdict),
    field("candidate/primitive", at(&Finding::candidate, &Answer::primitive), "what the candidate shows",
          {.column = "candidate_id", .record = "id"}),
    field("reference/primitive", at(&Finding::reference, &Answer::primitive), "what the reference shows",
          {.column = "reference_id"}),
    field("candidate/camera_depth", at(&Finding::candidate, &Answer::camera_depth), "",
          {.unit = scene_units, .column = "candidate_depth", .record = "depth"}),
    field("candidate/camera_depth_bits", as<Bits>(at(&Finding::candidate, &Answer::camera_depth)), the_bits),
    field("reference/camera_depth", at(&Finding::reference, &Answer::camera_depth), "",
          {.unit = scene_units, .column = "reference_depth"}),
    field("reference/camera_depth_bits", as<Bits>(at(&Finding::reference, &Answer::camera_depth)), the_bits),
    field("eps_px", &Finding::eps_px, "half-side of the square that the answer was judged in",
          {.unit = "px"}),
    field("candidate_depth_bound/low", at(&Finding::candidate_depth, &DepthBound::low),
          "least admissible depth", {.unit = scene_units, .column = "depth_low"}),
    field("candidate_depth_bound/truth", at(&Finding::candidate_depth, &DepthBound::truth), "true depth",
          {.unit = scene_units, .column = "depth_truth"}),
    field("candidate_depth_bound/high", at(&Finding::candidate_depth, &DepthBound::high),
          "largest admissible depth", {.unit = scene_units, .column = "depth_high"}),
    field("error_over_bound", &Finding::error_over_bound, "of the candidate's depth; NaN for background"),
};

}  // namespace zproof
