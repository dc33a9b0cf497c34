#include "compare/first_pass/law_maker.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

/// The surroundings' scene, and triangles that are seen edge-on, or are points.
Scene extended(const Surroundings& s) {
    Scene scene = s.scene;
    const auto add = [&](const CornersWorld& p) {
        const auto first = std::uint32_t(scene.vertices.position_world.size());
        scene.vertices.position_world.insert(scene.vertices.position_world.end(), p.begin(), p.end());
        scene.triangles.push_back({first, first + 1, first + 2});
    };
    const glm::vec3 eye = s.view.camera.eye_world, away = eye - glm::vec3(s.view.camera.back);
    add({eye, away, away + glm::vec3(s.view.camera.right)});
    add({away, away, away});
    return scene;
}

std::vector<PrimitiveId> all_of(const Scene& scene) {
    std::vector<PrimitiveId> ids;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) ids.push_back(PrimitiveId(i));
    return ids;
}

/// Are they the same bits? Two laws that settle nothing may differ.
void expect_same(const DepthLaw& law, const DepthLaw& expected) {
    EXPECT_EQ(std::isinf(law.relative), std::isinf(expected.relative));
    if (std::isinf(law.relative) && std::isinf(expected.relative)) return;
    using Bits = std::array<std::uint64_t, sizeof(DepthLaw) / sizeof(double)>;
    EXPECT_EQ(std::bit_cast<Bits>(law), std::bit_cast<Bits>(expected))
        << law.own_error << " " << expected.own_error << ", " << law.absolute << " " << expected.absolute;
}

template <class Numbers>
auto bits(const Numbers& numbers) {
    return std::bit_cast<std::array<std::uint64_t, sizeof(Numbers) / sizeof(double)>>(numbers);
}

/// Two tolerances that hold nowhere may differ.
template <class Tolerance>
void expect_same_tolerance(const Tolerance& a, const Tolerance& b) {
    EXPECT_EQ(a.least, b.least);
    EXPECT_EQ(a.most, b.most);
    EXPECT_TRUE(a.least > a.most || bits(a) == bits(b));
}

/// Pairs of renderers: all that have laws in common terms, one way and the other, and one that has not.
std::vector<std::pair<Precision, Precision>> pairs() {
    const RasterPrecision ours{.transform = Arithmetic::float64};
    const RasterPrecision from_eye{
        .transform = Arithmetic::float64, .origin = Origin::eye, .subpixel_bits = 4};
    return {{ours, RayPrecision{}}, {RayPrecision{}, from_eye}, {ours, PlaneRayPrecision{}}};
}

/// One of these pairs before a scene.
struct Pair {
    Surroundings s;
    Scene scene;
    Frame frame;
    Witness candidate, reference;

    explicit Pair(std::uint32_t seed)
        : s(random_surroundings(seed)),
          scene(extended(s)),
          frame({s.view.width, s.view.height}),
          candidate(scene, s.view, {frame, pairs()[seed % 3].first}),
          reference(scene, s.view, {frame, pairs()[seed % 3].second}) {}
};

/// Code for an instruction set with vectors that wide reads it as aligned.
static_assert(alignof(LawMaker::Lens) == four_alignment);

TEST(LawMaker, GivesEachTriangleTheBitsOfItsOwnLaw) {
    int asked = 0, of_nothing = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const auto& [s, scene, frame, candidate, reference] = Pair(seed);
        LawsOfBoth laws{{law_of_nothing}, {law_of_nothing}};
        LawMaker(scene, candidate, reference).make(all_of(scene), 1, laws);
        EXPECT_EQ(laws.candidate[0].relative, law_of_nothing.relative);
        for (const PrimitiveId id : all_of(scene)) {
            const std::size_t place = 1 + std::size_t(id);
            const TriangleInView triangle = candidate.triangle_in_view(id);
            expect_same(laws.candidate[place], depth_law_of(triangle, candidate.bounds()));
            expect_same(laws.reference[place], depth_law_of(triangle, reference.bounds()));
            ++asked, of_nothing += std::isinf(laws.candidate[place].relative);
        }
    }
    EXPECT_GT(asked, 2000);
    EXPECT_GT(of_nothing, 300) << "among them triangles of which nothing is known";
    EXPECT_LT(of_nothing, asked / 2);
}

/// Of any number of triangles.
TEST(LawMaker, GivesEachTriangleTheToleranceOfItsLaws) {
    int usable = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const auto& [s, scene, frame, candidate, reference] = Pair(seed);
        const PixelBox tile{0, s.y, s.view.width, s.y + 1};
        const std::vector<PrimitiveId> triangles = all_of(scene);
        std::vector<DepthTolerance> far_off(triangles.size());
        std::vector<CornerTolerance> next_to_corners(triangles.size());
        LawMaker(scene, candidate, reference).make_tolerances(triangles, tile, {far_off, next_to_corners});
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const TriangleInView triangle = candidate.triangle_in_view(triangles[i]);
            const Tolerances expected =
                tolerances_of(depth_law_of(triangle, candidate.bounds()),
                              depth_law_of(triangle, reference.bounds()), s.view.camera.projection, tile);
            expect_same_tolerance(far_off[i], expected.far_off);
            expect_same_tolerance(next_to_corners[i], expected.next_to_corners);
            ++asked, usable += next_to_corners[i].least <= next_to_corners[i].most;
        }
    }
    EXPECT_GT(usable, asked / 8);
}

}  // namespace
}  // namespace zproof
