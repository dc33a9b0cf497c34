#include <cmath>

#include "cli/selftest/catalogue.h"
#include "cli/selftest/spot.h"

namespace zproof::selftest {
namespace {

const Expected pass{.answer = Expected::Answer::pass, .classes = {}, .count = {}};

/// The reference lies at one pixel: that is held against it, and nobody else.
const Expected reference_is_wrong_once{
    .answer = Expected::Answer::pass, .classes = {PixelClass::reference_wrong}, .count = 1};

/// The largest float within the bound.
Frame at_the_bound(const Stage& stage) {
    Frame frame = stage.good;
    const Pixel p = amid_a_triangle(stage);
    const double high = lawful_depths(stage, p).high;
    float depth = float(high);
    if (depth > high) depth = std::nextafter(depth, 0.0f);
    frame.camera_depth.at(p.x, p.y) = depth;
    return frame;
}

Frame reference_with_a_hole(const Stage& stage) {
    Frame frame = stage.reference;
    const Pixel p = amid_a_triangle(stage);
    frame.primitive.at(p.x, p.y) = PrimitiveId::none;
    frame.camera_depth.at(p.x, p.y) = background_depth;
    return frame;
}

}  // namespace

std::vector<Fault> clean_frames() {
    const auto good = [](const Stage& stage) { return stage.good; };
    const auto reference = [](const Stage& stage) { return stage.reference; };
    return {
        {.name = "untouched",
         .sentence = "the renderer's own frame, two million pixels",
         .expected = pass,
         .inject = good,
         .stage_size = StageSize::large},
        {.name = "untouched_small", .sentence = "the renderer's own frame", .expected = pass, .inject = good},
        {.name = "equal_to_reference",
         .sentence =
             "the reference's frame, bit by bit, from a renderer that promises what the reference does",
         .expected = pass,
         .inject = reference,
         .stage_size = StageSize::large,
         .promise = Promise::of_reference},
        {.name = "depth_at_its_bound",
         .sentence = "one depth is the last float32 within its bound",
         .expected = pass,
         .inject = at_the_bound},
        {.name = "hole_in_the_reference",
         .sentence = "the frame is good, the reference has a hole",
         .expected = reference_is_wrong_once,
         .inject = reference_with_a_hole,
         .target = Target::reference},
    };
}

}  // namespace zproof::selftest
