/// Attributes before the judge: those of our rasterizer and of Embree are within their bounds, and each way
/// of getting one wrong is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/attributes/attribute_check.h"
#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/interpolation.h"
#include "rasterizer/rasterizer.h"
#include "rasterizer/surface.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

constexpr int width = 160, height = 90;
constexpr std::size_t bary_u = 0, bary_v = 1, uv_v = 3, normal_x = 4, position_x = 7;

std::uint64_t wrong_in(const Verdict& verdict) {
    return verdict.counts[std::size_t(PixelClass::wrong_attribute)];
}

std::string first_of(const Verdict& verdict) {
    for (const Finding& f : verdict.findings)
        if (const auto& wrong = f.wrong_attribute)
            return std::to_string(f.x) + ", " + std::to_string(f.y) + ": " +
                   std::string(attribute_channels[wrong->channel].name) + " is " +
                   std::to_string(wrong->value) + ", admissible " + std::to_string(wrong->low) + " to " +
                   std::to_string(wrong->high);
    return "";
}

class AttributesOf : public testing::TestWithParam<std::string> {
  protected:
    Frame rendered(const View& view) const {
        Frame frame = rasterizer::render(loaded.scene, view);
        frame.attributes = rasterizer::attributes_of(loaded.scene, view, frame);
        return frame;
    }

    /// Beside Embree's frame.
    Verdict judged(const View& view, const Frame& frame, const Precision& precision) const {
        return judge(loaded.scene, view, {frame, precision},
                     {embree.trace(view), oracle::embree_precision()});
    }

    using Change = std::function<void(Attributes& at, const View& view, int x, int y, PrimitiveId id)>;
    /// Pixels of all views at which our rasterizer's attributes are wrong once they are changed.
    std::uint64_t wrong_after(const Change& change) const {
        std::uint64_t wrong = 0;
        for (const View& view : loaded.views) {
            Frame frame = rendered(view);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (const PrimitiveId id = frame.primitive.at(x, y); id != PrimitiveId::none)
                        change(frame.attributes, view, x, y, id);
            wrong += wrong_in(judged(view, frame, rasterizer::precision()));
        }
        return wrong;
    }

    Loaded loaded = generate_suite_scene(GetParam(), width, height);
    oracle::Embree embree{loaded.scene};
};

TEST_P(AttributesOf, OurRasterizerAreWithinTheirBounds) {
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        const Verdict verdict = judged(view, rendered(view), rasterizer::precision());
        EXPECT_EQ(wrong_in(verdict), 0u) << first_of(verdict);
    }
}

TEST_P(AttributesOf, EmbreeAreWithinTheirBounds) {
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        const Verdict verdict =
            judged(view, embree.trace_with_barycentrics(view), oracle::embree_precision());
        EXPECT_EQ(wrong_in(verdict), 0u) << first_of(verdict);
    }
}

TEST_P(AttributesOf, OurRasterizerOnEmbreesTrianglesAreWithinTheBoundsOfEmbree) {
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        Frame mixed = embree.trace_with_barycentrics(view);
        mixed.attributes = rasterizer::attributes_of(loaded.scene, view, mixed);
        const Verdict verdict = judged(view, mixed, oracle::embree_precision());
        EXPECT_EQ(wrong_in(verdict), 0u) << first_of(verdict);
    }
}

/// In the image, as if depth did not matter: weights are multiplied by their corners' depths.
TEST_P(AttributesOf, AnAffineInterpolationAreFoundWrong) {
    const std::uint64_t wrong =
        wrong_after([&](Attributes& at, const View& view, int x, int y, PrimitiveId id) {
            if (view.camera.projection != Projection::perspective) return;
            const glm::uvec3& t = loaded.scene.triangles[std::size_t(id)];
            const auto depth = [&](std::uint32_t vertex) {
                const glm::dvec3 p{loaded.scene.vertices.position_world[vertex]};
                return -glm::dot(view.camera.back, p - glm::dvec3(view.camera.eye_world));
            };
            float &u = at.planes[bary_u].at(x, y), &v = at.planes[bary_v].at(x, y);
            const double w0 = (1 - u - v) * depth(t.x), w1 = u * depth(t.y), w2 = v * depth(t.z);
            u = float(w1 / (w0 + w1 + w2));
            v = float(w2 / (w0 + w1 + w2));
        });
    EXPECT_GT(wrong, 1000u);
}

/// A picture that lies half a step of the grid beside its place uses all that snapping may do.
TEST_P(AttributesOf, APictureMovedByTheGridAreWithinTheirBoundsAndATenthFartherAreNot) {
    const auto wrong_when_moved = [&](double share) {
        std::uint64_t wrong = 0;
        for (const View& view : loaded.views) {
            Frame frame = rasterizer::render(loaded.scene, view);
            for (const std::size_t channel : {bary_u, bary_v})
                frame.attributes.planes[channel] = Plane<float>(frame.size());
            const glm::dvec3 eye{view.camera.eye_world};
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const PrimitiveId id = frame.primitive.at(x, y);
                    if (id == PrimitiveId::none) continue;
                    const glm::uvec3& t = loaded.scene.triangles[std::size_t(id)];
                    const auto from_eye = [&](std::uint32_t vertex) {
                        return glm::dvec3(loaded.scene.vertices.position_world[vertex]) - eye;
                    };
                    const auto weights_at = [&](double dx, double dy) {
                        return rasterizer::barycentrics(
                            rasterizer::pixel_ray(view, x + 0.5 + dx, y + 0.5 + dy),
                            {from_eye(t.x), from_eye(t.y), from_eye(t.z)});
                    };
                    auto b = weights_at(share / 512, share / 512);
                    if (std::ranges::min(b) < 0) b = weights_at(0, 0);
                    frame.attributes.planes[bary_u].at(x, y) = float(b[1]);
                    frame.attributes.planes[bary_v].at(x, y) = float(b[2]);
                }
            wrong += wrong_in(judged(view, frame, rasterizer::precision()));
        }
        return wrong;
    };
    EXPECT_EQ(wrong_when_moved(1.0), 0u);
    EXPECT_GT(wrong_when_moved(1.1), 1000u);
}

TEST_P(AttributesOf, SwappedCornersAreFoundWrong) {
    EXPECT_GT(wrong_after([](Attributes& at, const View&, int x, int y, PrimitiveId) {
                  std::swap(at.planes[bary_u].at(x, y), at.planes[bary_v].at(x, y));
              }),
              1000u);
}

TEST_P(AttributesOf, TheCameraAsPositionsAreFoundWrong) {
    const std::uint64_t wrong = wrong_after([](Attributes& at, const View& view, int x, int y, PrimitiveId) {
        glm::dvec3 p_world;
        for (int axis = 0; axis < 3; ++axis)
            p_world[axis] = at.planes[position_x + std::size_t(axis)].at(x, y);
        const glm::dvec3 from_eye = p_world - glm::dvec3(view.camera.eye_world);
        const glm::dvec3* axes[] = {&view.camera.right, &view.camera.up, &view.camera.back};
        for (std::size_t axis = 0; axis < 3; ++axis)
            at.planes[position_x + axis].at(x, y) = float(glm::dot(*axes[axis], from_eye));
    });
    EXPECT_GT(wrong, 1000u);
}

TEST_P(AttributesOf, WhatIsNoNumberAreFoundWrong) {
    const auto set = [](std::size_t channel, float value) {
        return [=](Attributes& at, const View&, int x, int y, PrimitiveId) {
            if (x == 80 && y % 10 == 0) at.planes[channel].at(x, y) = value;
        };
    };
    EXPECT_GT(wrong_after(set(bary_v, NAN)), 0u);
    EXPECT_GT(wrong_after(set(position_x, INFINITY)), 0u);
}

/// A value at the end of its bound passes; one that uses 1.1 of it fails.
TEST_P(AttributesOf, APixelMayUseAllOfTheBoundAndNoMore) {
    const View& view = loaded.views.front();
    Frame frame = rendered(view);
    const AttributeCheck check(loaded.scene, view, frame, rasterizer::precision());
    int tried = 0;
    for (const std::size_t channel : {bary_u, position_x})
        for (int y = 5; y < height; y += 10)
            for (int x = 5; x < width; x += 10) {
                if (frame.primitive.at(x, y) == PrimitiveId::none) continue;
                float& value = frame.attributes.planes[channel].at(x, y);
                const float right = value;
                value = 1e6f;
                const auto wrong = check.at({x, y}).wrong;
                value = right;
                const float step = std::nextafter(std::abs(right), HUGE_VALF) - std::abs(right);
                if (!wrong || 0.1 * (wrong->high - wrong->low) < 8 * step) continue;
                ++tried;
                const auto using_share = [&](double share) {
                    value = float(wrong->truth + share * (wrong->high - wrong->truth));
                    const bool is_wrong = check.at({x, y}).wrong.has_value();
                    value = float(wrong->truth + share * (wrong->low - wrong->truth));
                    const bool is_wrong_below = check.at({x, y}).wrong.has_value();
                    value = right;
                    return is_wrong + is_wrong_below;
                };
                EXPECT_EQ(using_share(0.9), 0) << x << ", " << y;
                EXPECT_EQ(using_share(1.1), 2) << x << ", " << y;
            }
    EXPECT_GT(tried, 20);
}

INSTANTIATE_TEST_SUITE_P(Suite, AttributesOf,
                         testing::Values("room", "textured_ground", "near_plane", "shared_edges"),
                         [](const auto& scene) { return scene.param; });

class UvOf : public AttributesOf {};

TEST_P(UvOf, FlippedInVAreFoundWrong) {
    EXPECT_GT(wrong_after([](Attributes& at, const View&, int x, int y, PrimitiveId) {
                  at.planes[uv_v].at(x, y) = 1 - at.planes[uv_v].at(x, y);
              }),
              1000u);
}

INSTANTIATE_TEST_SUITE_P(Suite, UvOf, testing::Values("textured_ground"),
                         [](const auto& scene) { return scene.param; });

/// No scene of the suite has normals: here each vertex has one of its own, and the first has none.
class NormalsOf : public AttributesOf {
  protected:
    NormalsOf() {
        for (const glm::vec3& p : loaded.scene.vertices.position_world)
            loaded.scene.vertices.normal_world.push_back(
                glm::normalize(glm::vec3(std::sin(3 * p.x), 2 + std::cos(5 * p.y), std::sin(p.z))));
        loaded.scene.vertices.normal_world[0] = glm::vec3(0);
    }

    using ChangeNormal = std::function<glm::vec3(const glm::vec3& normal)>;
    std::uint64_t wrong_after_each(const ChangeNormal& change) const {
        return wrong_after([&](Attributes& at, const View&, int x, int y, PrimitiveId) {
            glm::vec3 normal;
            for (int axis = 0; axis < 3; ++axis)
                normal[axis] = at.planes[normal_x + std::size_t(axis)].at(x, y);
            normal = change(normal);
            for (int axis = 0; axis < 3; ++axis)
                at.planes[normal_x + std::size_t(axis)].at(x, y) = normal[axis];
        });
    }
};

TEST_P(NormalsOf, AnyLengthAreWithinTheirBounds) {
    for (const float length : {1.0f, 0.37f, 1e6f})
        EXPECT_EQ(wrong_after_each([=](const glm::vec3& normal) { return length * normal; }), 0u) << length;
}

TEST_P(NormalsOf, AnotherDirectionAreFoundWrong) {
    EXPECT_GT(wrong_after_each([](const glm::vec3& normal) { return -normal; }), 1000u);
    EXPECT_GT(wrong_after_each([](const glm::vec3&) { return glm::vec3(0); }), 1000u);
    EXPECT_GT(wrong_after_each([](const glm::vec3& n) { return glm::vec3(n.x, n.z, n.y); }), 1000u);
    EXPECT_GT(wrong_after_each([](const glm::vec3& n) { return n + glm::vec3(0.1f, 0, 0); }), 1000u);
}

TEST_P(NormalsOf, TheFlatTriangleAreFoundWrong) {
    const std::uint64_t wrong = wrong_after([&](Attributes& at, const View&, int x, int y, PrimitiveId id) {
        const glm::uvec3& t = loaded.scene.triangles[std::size_t(id)];
        const auto& p = loaded.scene.vertices.position_world;
        const glm::vec3 normal = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
        for (int axis = 0; axis < 3; ++axis) at.planes[normal_x + std::size_t(axis)].at(x, y) = normal[axis];
    });
    EXPECT_GT(wrong, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Suite, NormalsOf, testing::Values("room", "textured_ground"),
                         [](const auto& scene) { return scene.param; });

TEST(Attributes, OfAnotherSceneOrRendererAreNotJudgedAndSaidSo) {
    const Loaded room = generate_suite_scene("room", width, height);
    const Frame empty({width, height});
    Attributes given;
    for (auto& plane : given.planes) plane = Plane<float>({width, height});
    EXPECT_EQ(
        unjudged_attributes(room.scene, room.views[0], empty.attributes, rasterizer::precision()).size(), 0u);
    EXPECT_EQ(unjudged_attributes(room.scene, room.views[0], given, rasterizer::precision()),
              (std::vector<std::string>{"uv not judged: the scene has none",
                                        "normal not judged: the scene has none"}));
    EXPECT_EQ(unjudged_attributes(room.scene, room.views[0], given, PlaneRayPrecision{}).size(), 4u);
}

/// Rounded edge functions are bounded in perspectives alone.
TEST(Attributes, OfRoundedEdgeFunctionsAreNotJudgedInParallelProjectionsAndSaidSo) {
    const RasterPrecision rounded{.edge_functions = EdgeFunctions::from_corner};
    Attributes given;
    for (auto& plane : given.planes) plane = Plane<float>({width, height});
    const Loaded parallel = generate_suite_scene("orthographic", width, height),
                 perspective = generate_suite_scene("room", width, height);
    EXPECT_EQ(unjudged_attributes(parallel.scene, parallel.views[0], given, rounded).size(), 4u);
    EXPECT_EQ(unjudged_attributes(perspective.scene, perspective.views[0], given, rounded).size(), 2u);
}

TEST(Attributes, OfSamplesAreJudgedAtTheirPlaces) {
    const Loaded loaded = generate_suite_scene("textured_ground", width, height);
    View view = loaded.views[0];
    view.sample.offset_px = {-0.375, 0.125};
    Frame frame = rasterizer::render(loaded.scene, view);
    frame.attributes = rasterizer::attributes_of(loaded.scene, view, frame);
    const Frame at_sample = oracle::Embree{loaded.scene}.trace(view);
    const auto defects = [&] {
        return defect_count(judge(loaded.scene, view, {frame, rasterizer::precision()},
                                  {at_sample, oracle::embree_precision()}));
    };
    EXPECT_EQ(defects(), 0u);
    View centre = view;
    centre.sample = {};
    frame.attributes = rasterizer::attributes_of(loaded.scene, centre, frame);
    EXPECT_GT(defects(), 1000u);
}

}  // namespace
}  // namespace zproof
