#include <cmath>
#include <limits>

#include "selftest/catalogue.h"
#include "selftest/fault_pixel.h"

namespace zproof::selftest {
namespace {

Expected one(PixelClass c) { return {.classes = {c}, .count = 1}; }

using Change = std::function<void(const Fixture&, Pixel, PrimitiveId&, float&)>;

enum class Shown { triangle, background };

/// A frame whose one pixel is changed.
std::function<Frame(const Fixture&)> at_one_pixel(Shown shown, const Change& change) {
    return [=](const Fixture& fixture) {
        Frame frame = fixture.good;
        const Pixel p = shown == Shown::triangle ? amid_a_triangle(fixture) : amid_background(fixture);
        change(fixture, p, frame.primitive.at(p.x, p.y), frame.camera_depth.at(p.x, p.y));
        return frame;
    };
}

Fault of_id(const std::string& name, const std::string& sentence, PixelClass c, const Change& change) {
    return {name, sentence, one(c), at_one_pixel(Shown::triangle, change)};
}

Fault of_depth(const std::string& name, const std::string& sentence, PixelClass c,
               const std::function<float(const DepthBound&)>& depth_of) {
    const Change change = [=](const Fixture& fixture, Pixel p, PrimitiveId&, float& depth) {
        depth = depth_of(admissible_depths(fixture, p));
    };
    return {name, sentence, one(c), at_one_pixel(Shown::triangle, change)};
}

Fault of_background(const std::string& name, const std::string& sentence, PixelClass c,
                    const Change& change) {
    return {name, sentence, one(c), at_one_pixel(Shown::background, change)};
}

float first_float_above(double bound) {
    const float nearest = float(bound);
    return nearest > bound ? nearest : std::nextafter(nearest, background_depth);
}

float first_float_below(double bound) { return -first_float_above(-bound); }

std::vector<Fault> faults_of_one_id() {
    return {
        of_id("one_wrong_id", "one pixel of two million names another triangle, its depth stays right",
              PixelClass::outside,
              [](const Fixture& fixture, Pixel p, PrimitiveId& id, float&) {
                  const Pixel other = amid_another_triangle(fixture, fixture.good.primitive.at(p.x, p.y));
                  id = fixture.good.primitive.at(other.x, other.y);
              }),
        of_id("one_hole", "one pixel is background", PixelClass::hole,
              [](const Fixture&, Pixel, PrimitiveId& id, float& depth) {
                  id = PrimitiveId::none;
                  depth = background_depth;
              }),
        of_id("id_out_of_range", "one id is the number of triangles, one more than the last",
              PixelClass::invalid,
              [](const Fixture& fixture, Pixel, PrimitiveId& id, float&) {
                  id = PrimitiveId{std::uint32_t(fixture.scene.triangles.size())};
              }),
        of_id("id_almost_background", "one id is 0xFFFFFFFE", PixelClass::invalid,
              [](const Fixture&, Pixel, PrimitiveId& id, float&) { id = PrimitiveId{0xFFFF'FFFE}; }),
        of_id("background_with_a_depth", "one id is background, the surface's depth is still there",
              PixelClass::invalid,
              [](const Fixture&, Pixel, PrimitiveId& id, float&) { id = PrimitiveId::none; }),
    };
}

std::vector<Fault> faults_of_one_depth() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {
        of_depth("depth_twice_its_bound_far", "one depth is too far by twice its bound",
                 PixelClass::wrong_depth,
                 [](const DepthBound& b) { return float(b.truth + 2 * (b.high - b.truth)); }),
        of_depth("depth_twice_its_bound_near", "one depth is too near by twice its bound",
                 PixelClass::wrong_depth,
                 [](const DepthBound& b) { return float(b.truth - 2 * (b.truth - b.low)); }),
        of_depth("depth_past_its_bound_far", "one depth is the first float32 beyond its bound",
                 PixelClass::wrong_depth, [](const DepthBound& b) { return first_float_above(b.high); }),
        of_depth("depth_past_its_bound_near", "one depth is the first float32 before its bound",
                 PixelClass::wrong_depth, [](const DepthBound& b) { return first_float_below(b.low); }),
        of_depth("depth_nan", "one depth is NaN", PixelClass::invalid,
                 [](const DepthBound&) { return std::numeric_limits<float>::quiet_NaN(); }),
        of_depth("depth_plus_infinity", "one triangle's depth is +infinity", PixelClass::wrong_depth,
                 [](const DepthBound&) { return infinity; }),
        of_depth("depth_minus_infinity", "one depth is -infinity", PixelClass::invalid,
                 [](const DepthBound&) { return -infinity; }),
        of_depth("depth_negative", "one depth has the wrong sign", PixelClass::invalid,
                 [](const DepthBound& b) { return float(-b.truth); }),
        // -0 is not less than 0: it is the number zero, and wrong because no surface is there.
        of_depth("depth_minus_zero", "one depth is -0", PixelClass::wrong_depth,
                 [](const DepthBound&) { return -0.0f; }),
        of_depth("depth_zero", "one depth is 0", PixelClass::wrong_depth,
                 [](const DepthBound&) { return 0.0f; }),
        of_depth("depth_subnormal", "one depth is the smallest float32 above 0", PixelClass::wrong_depth,
                 [](const DepthBound&) { return std::numeric_limits<float>::denorm_min(); }),
    };
}

std::vector<Fault> faults_of_background() {
    const auto borrow = [](const Fixture& fixture) {
        const Pixel p = amid_a_triangle(fixture);
        return Answer{fixture.good.primitive.at(p.x, p.y), fixture.good.camera_depth.at(p.x, p.y)};
    };
    return {
        of_background("filled_background", "one background pixel holds a triangle with its depth",
                      PixelClass::outside,
                      [=](const Fixture& fixture, Pixel, PrimitiveId& id, float& depth) {
                          id = borrow(fixture).primitive;
                          depth = borrow(fixture).camera_depth;
                      }),
        of_background("background_at_the_far_plane", "one background pixel has the far plane's depth",
                      PixelClass::invalid,
                      [](const Fixture& fixture, Pixel, PrimitiveId&, float& depth) {
                          depth = float(fixture.view.camera.far_depth);
                      }),
        of_background("background_nan", "one background pixel has the depth NaN", PixelClass::invalid,
                      [](const Fixture&, Pixel, PrimitiveId&, float& depth) {
                          depth = std::numeric_limits<float>::quiet_NaN();
                      }),
        of_background("background_zero", "one background pixel has the depth 0", PixelClass::invalid,
                      [](const Fixture&, Pixel, PrimitiveId&, float& depth) { depth = 0; }),
    };
}

}  // namespace

std::vector<Fault> faults_of_a_pixel() {
    std::vector<Fault> all = faults_of_one_id();
    all.front().fixture_size = FixtureSize::large;
    for (auto& part : {faults_of_one_depth(), faults_of_background()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace zproof::selftest
