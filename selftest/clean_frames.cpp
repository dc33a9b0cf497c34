#include <cmath>

#include "selftest/catalogue.h"
#include "selftest/fault_pixel.h"

namespace zproof::selftest {
namespace {

const Expected pass{.answer = Expected::Answer::pass, .classes = {}, .count = {}};

/// The reference lies at one pixel: that is held against it, and nobody else.
const Expected reference_is_wrong_once{
    .answer = Expected::Answer::pass, .classes = {PixelClass::reference_wrong}, .count = 1};

/// The largest float within the bound.
Frame at_the_bound(const Fixture& fixture) {
    Frame frame = fixture.good;
    const Pixel p = amid_a_triangle(fixture);
    const double high = admissible_depths(fixture, p).high;
    float depth = float(high);
    if (depth > high) depth = std::nextafter(depth, 0.0f);
    frame.camera_depth.at(p.x, p.y) = depth;
    return frame;
}

Frame reference_with_a_hole(const Fixture& fixture) {
    Frame frame = fixture.reference;
    const Pixel p = amid_a_triangle(fixture);
    frame.primitive.at(p.x, p.y) = PrimitiveId::none;
    frame.camera_depth.at(p.x, p.y) = background_depth;
    return frame;
}

}  // namespace

std::vector<Fault> clean_frames() {
    const auto good = [](const Fixture& fixture) { return fixture.good; };
    const auto reference = [](const Fixture& fixture) { return fixture.reference; };
    return {
        {.name = "untouched",
         .sentence = "the renderer's own frame, two million pixels",
         .expected = pass,
         .inject = good,
         .fixture_size = FixtureSize::large},
        {.name = "untouched_small", .sentence = "the renderer's own frame", .expected = pass, .inject = good},
        {.name = "equal_to_reference",
         .sentence =
             "the reference's frame, bit by bit, from a renderer that promises what the reference does",
         .expected = pass,
         .inject = reference,
         .fixture_size = FixtureSize::large,
         .precision_source = PrecisionSource::of_reference},
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
