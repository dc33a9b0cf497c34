#include <functional>
#include <limits>
#include <utility>

#include "rasterizer/interpolation.h"
#include "selftest/catalogue.h"
#include "selftest/fault_pixel.h"

namespace zproof::selftest {
namespace {

enum Channel : std::size_t { bary_u = 0, bary_v = 1, position_z = 9 };

/// The good frame with its attributes, which are right.
Frame with_attributes(const Fixture& fixture) {
    Frame frame = fixture.good;
    frame.attributes = rasterizer::attributes_of(fixture.scene, fixture.view, frame);
    return frame;
}

struct InterpolatedPixel {
    const Fixture& fixture;
    Attributes& attributes;
    int x, y;
    PrimitiveId id;

    float& operator[](std::size_t channel) const { return attributes.planes[channel].at(x, y); }
};

std::function<Frame(const Fixture&)> at_each_pixel(
    const std::function<void(const InterpolatedPixel&)>& change) {
    return [=](const Fixture& fixture) {
        Frame frame = with_attributes(fixture);
        for (int y = 0; y < fixture.view.height; ++y)
            for (int x = 0; x < fixture.view.width; ++x)
                if (const PrimitiveId id = frame.primitive.at(x, y); id != PrimitiveId::none)
                    change({fixture, frame.attributes, x, y, id});
        return frame;
    };
}

/// Weights in the image, as if depth did not matter: each is multiplied by its corner's depth.
void make_affine(const InterpolatedPixel& seen) {
    const Camera& camera = seen.fixture.view.camera;
    const Scene& scene = seen.fixture.scene;
    const glm::uvec3& t = scene.triangles[std::size_t(seen.id)];
    const auto depth = [&](std::uint32_t vertex) {
        const glm::dvec3 p{scene.vertices.position_world[vertex]};
        return -glm::dot(camera.back, p - glm::dvec3(camera.eye_world));
    };
    const double u = seen[bary_u], v = seen[bary_v];
    const double w0 = (1 - u - v) * depth(t.x), w1 = u * depth(t.y), w2 = v * depth(t.z);
    seen[bary_u] = float(w1 / (w0 + w1 + w2));
    seen[bary_v] = float(w2 / (w0 + w1 + w2));
}

Frame with_one_nan(const Fixture& fixture) {
    Frame frame = with_attributes(fixture);
    const Pixel p = amid_a_triangle(fixture);
    frame.attributes.planes[bary_v].at(p.x, p.y) = std::numeric_limits<float>::quiet_NaN();
    return frame;
}

}  // namespace

std::vector<Fault> faults_of_attributes() {
    const Expected wrong{.classes = {PixelClass::wrong_attribute}, .count = {}};
    return {
        {"right_attributes",
         "nothing is wrong: barycentrics and positions are there, too",
         {.answer = Expected::Answer::pass, .classes = {}, .count = {}},
         with_attributes},
        {"barycentrics_affine", "barycentrics are interpolated without regard to perspective", wrong,
         at_each_pixel(make_affine)},
        {"barycentrics_swapped", "barycentrics are those of the other two corners", wrong,
         at_each_pixel([](const InterpolatedPixel& seen) { std::swap(seen[bary_u], seen[bary_v]); })},
        {"positions_left_handed", "positions have z the other way round", wrong,
         at_each_pixel([](const InterpolatedPixel& seen) { seen[position_z] = -seen[position_z]; })},
        {"barycentric_nan",
         "one barycentric is NaN",
         {.classes = {PixelClass::wrong_attribute}, .count = 1},
         with_one_nan},
    };
}

}  // namespace zproof::selftest
