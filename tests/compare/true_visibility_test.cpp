/// What is said to be truly visible all over a square must be so in rationals, wherever in it a centre lies.
#include "compare/admissible/true_visibility.h"

#include <gtest/gtest.h>

#include "math/rational.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

/// What rationals have at a pixel's centre.
class TruthAt {
  public:
    TruthAt(const Scene& scene, const View& view, const PixelCoord& place)
        : scene_(scene), view_(view), ray_(view, place.x, place.y) {}

    /// Is the answer there, in front of all else that is?
    bool is(PrimitiveId answer) const {
        const auto asked = answer == PrimitiveId::none ? std::nullopt : depth_of(std::uint32_t(answer));
        if (answer != PrimitiveId::none && !asked) return false;
        for (std::uint32_t t = 0; t < scene_.triangles.size(); ++t) {
            if (PrimitiveId(t) == answer) continue;
            const auto other = depth_of(t);
            if (other && (!asked || sign(*other - *asked) >= 0)) return false;
        }
        return true;
    }

  private:
    /// The triangle's inverse depth, if it holds the centre between near and far.
    std::optional<Rational> depth_of(std::uint32_t triangle) const {
        const auto image = image_of(ray_, corners<Rational>(corners_of(scene_, triangle)));
        if (!image) return std::nullopt;
        for (const auto& edge : image->edge)
            if (sign(edge.c) < 0) return std::nullopt;
        const Camera& c = view_.camera;
        const bool perspective = c.projection == Projection::perspective;
        const Rational here = image->inverse_depth.c, one(1);
        const auto at = [&](double depth) { return perspective ? one / Rational(depth) : -Rational(depth); };
        if (sign(here - at(c.near_depth)) > 0) return std::nullopt;
        if (std::isfinite(c.far_depth) && sign(here - at(c.far_depth)) < 0) return std::nullopt;
        return here;
    }

    const Scene& scene_;
    const View& view_;
    ViewRay<Rational> ray_;
};

TEST(TrueVisibility, IsThatOfRationalsWhereverACentreLies) {
    int said = 0, said_of_background = 0;
    for (std::uint32_t seed = 0; seed < 12000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Rng rng(seed);
        const ViewBounds bounds(s.view, seed % 2 ? raster_precision() : ray_precision());
        const ViewRay<double> ray(s.view, s.x, s.y);
        std::vector<Neighbour> seen;
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t)
            seen.push_back(seen_at(ray, BoundedTriangle(bounds, corners_of(s.scene, t))));
        const int half = rng.below(3), dx = rng.below(7) - 3, dy = rng.below(7) - 3;
        const SquareInView square{{double(dx), double(dy)}, double(half)};
        const auto say = [&](PrimitiveId answer, const Neighbour* n) {
            const TrueVisibility visibility(s.view.camera, square, n);
            if (!visibility.is_answer_there()) return;
            if (!std::ranges::all_of(seen, [&](const Neighbour& other) {
                    return &other == n || visibility.is_seen_past(other);
                }))
                return;
            for (int y = -half; y <= half; ++y)
                for (int x = -half; x <= half; ++x)
                    ASSERT_TRUE(TruthAt(s.scene, s.view, {s.x + dx + x, s.y + dy + y}).is(answer));
            ++(n ? said : said_of_background);
        };
        say(PrimitiveId::none, nullptr);
        for (std::uint32_t t = 0; t < seen.size(); ++t) say(PrimitiveId(t), &seen[t]);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(said, 400);
    EXPECT_GT(said_of_background, 100);
}

}  // namespace
}  // namespace zproof
