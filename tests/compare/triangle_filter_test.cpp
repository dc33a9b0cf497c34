/// What the filter says for certain, exact rationals must say as well.
#include "compare/search/triangle_filter.h"

#include <gtest/gtest.h>

#include "compare/search/acquaintance.h"
#include "compare/truth/admissible.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

/// The corners of a box around a pixel, as offsets from its centre.
std::array<std::array<double, 2>, 4> corners_of_box(double half_x, double half_y) {
    return {{{-half_x, -half_y}, {half_x, -half_y}, {half_x, half_y}, {-half_x, half_y}}};
}

/// An affine value over a box: its least and greatest sign at the corners.
struct Signs {
    int least = 1, greatest = -1;
};
Signs signs_in(const Affine<Rational>& f, double half_x, double half_y) {
    Signs signs;
    for (const auto& [x, y] : corners_of_box(half_x, half_y)) {
        const int s = sign(f.at(Rational(x), Rational(y)));
        signs.least = std::min(signs.least, s);
        signs.greatest = std::max(signs.greatest, s);
    }
    return signs;
}

class Filtered {
  public:
    Filtered(const Surroundings& s, const CornersWorld& p)
        : image(image_of(Sight<Rational>(s.view, s.x, s.y), corners<Rational>(p))),
          filter(TriangleFilters(s.view).of(p)) {}

    std::optional<TriangleImage<Rational>> image;
    TriangleFilter filter;
};

/// Holds the filter's word for a square against exact signs, and counts it.
void compare_places(const Surroundings& s, const CornersWorld& p, double half, std::array<int, 3>& said) {
    const Filtered f(s, p);
    const auto place = f.filter.place_of({double(s.x), double(s.y), half, half});
    ++said[std::size_t(place)];
    if (!f.filter.is_trusted) return;
    ASSERT_TRUE(f.image) << "trusted, and edge-on";
    bool covers = true, may_meet = true;
    for (const Affine<Rational>& e : f.image->edge) {
        const Signs signs = signs_in(e, half, half);
        covers = covers && signs.least > 0;
        may_meet = may_meet && signs.greatest >= 0;
    }
    ASSERT_TRUE(place != TriangleFilter::Place::covers || covers);
    ASSERT_TRUE(place != TriangleFilter::Place::misses || !may_meet);
}

TEST(TriangleFilter, NeverSaysCoversOrMissesWhereRationalsSayOtherwise) {
    std::array<int, 3> said{};
    for (std::uint32_t seed = 0; seed < 1200; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t)
            compare_places(s, corners_of(s.scene, t), std::exp2(dice.between(-12, 2)), said);
        if (HasFatalFailure()) return;
    }
    for (const int count : said) EXPECT_GT(count, 50);
}

/// Half-sides of squares around the pixel whose corner an edge meets, but for next to nothing.
std::vector<double> halves_that_just_touch(const Surroundings& s, const CornersWorld& p, Dice& dice) {
    std::vector<double> halves;
    const auto image = image_of(Sight<Rational>(s.view, s.x, s.y), corners<Rational>(p));
    for (std::size_t i = 0; image && i < 3; ++i) {
        const Affine<Rational>& e = image->edge[i];
        const auto half = double(Rational(abs(e.c) / (abs(e.a) + abs(e.b))));
        if (std::isfinite(half))
            halves.push_back(half * (1 + std::ldexp(dice.between(-1, 1), -20 - dice.below(28))));
    }
    return halves;
}

/// The origin of sight is a small difference of large numbers there: its rounding counts.
TEST(TriangleFilter, IsRightWhereParallelSightComesFromFarAway) {
    std::array<int, 3> said{};
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        Surroundings s{random_view(dice), {}, dice.below(16), dice.below(16), {}};
        Camera& c = s.view.camera;
        c.projection = Projection::parallel;
        c.eye_world = glm::vec3(dice.between(-1, 1) * 0x1p20 * c.right + dice.between(-1, 1) * 0x1p20 * c.up);
        const double u = -glm::dot(c.right, glm::dvec3(c.eye_world)),
                     v = -glm::dot(c.up, glm::dvec3(c.eye_world));
        c.window = {.left = u - 1, .right = u + 1, .bottom = v - 1, .top = v + 1};
        s.scene = random_crowd(dice, s.view, s.x, s.y);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t)
            for (const double half : halves_that_just_touch(s, corners_of(s.scene, t), dice))
                compare_places(s, corners_of(s.scene, t), half, said);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(said[std::size_t(TriangleFilter::Place::misses)], 50);
}

/// Two corners of a triangle of the crowd, and one far behind the third.
CornersWorld with_a_far_corner(CornersWorld p, const View& view, Dice& dice) {
    const glm::vec3 eye = view.camera.eye_world;
    const std::size_t far = std::size_t(dice.below(3));
    p[far] = eye + float(std::exp2(dice.between(4, 24))) * (p[far] - eye) + (p[(far + 1) % 3] - eye);
    return p;
}

/// Edges that end at the far corner are less certain by far than the one that does not.
TEST(TriangleFilter, IsRightOfTrianglesWithOneFarCorner) {
    std::array<int, 3> said{};
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            const CornersWorld p = with_a_far_corner(corners_of(s.scene, t), s.view, dice);
            for (const double half : halves_that_just_touch(s, p, dice)) compare_places(s, p, half, said);
        }
        if (HasFatalFailure()) return;
    }
    for (const int count : said) EXPECT_GT(count, 50);
}

TEST(TriangleFilter, AnEdgesErrorDoesNotDependOnTheThirdCorner) {
    int compared = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        Dice dice(seed);
        const Surroundings s = random_surroundings(seed);
        const TriangleFilters filters(s.view);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            CornersWorld p = corners_of(s.scene, t);
            const TriangleFilter one = filters.of(p);
            p[0] = float(1 + dice.between(0, 100)) * p[0] + p[1];
            const TriangleFilter other = filters.of(p);
            if (!one.is_trusted || !other.is_trusted) continue;
            EXPECT_EQ(one.edge_error[0], other.edge_error[0]);
            ++compared;
        }
    }
    EXPECT_GT(compared, 100);
}

TEST(TriangleFilter, NeverOrdersTwoPlanesOtherwiseThanRationals) {
    std::array<int, 3> said{};
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        for (std::uint32_t t = 1; t < s.scene.triangles.size(); ++t) {
            const Filtered f(s, corners_of(s.scene, t)), g(s, corners_of(s.scene, t - 1));
            if (!f.filter.is_trusted || !g.filter.is_trusted) continue;
            const double half = std::exp2(dice.between(-12, 0));
            const int order = order_in({double(s.x), double(s.y), half, half}, f.filter, g.filter);
            const Signs signs = signs_in(f.image->nearness - g.image->nearness, half, half);
            ASSERT_TRUE(order != 1 || signs.least > 0);
            ASSERT_TRUE(order != -1 || signs.greatest < 0);
            ++said[std::size_t(order + 1)];
        }
    }
    EXPECT_GT(said[0], 50);
    EXPECT_GT(said[1], 20);
    EXPECT_GT(said[2], 50);
}

/// On a line through the image, never on both sides of it; found beside it in every direction.
TEST(TriangleFilter, AnEdgeOnTriangleIsMissedBesideItsLineOnly) {
    const View view = pixel_view(Projection::parallel, 16, 16);
    const Scene scene = scene_of(view, {{{{2, 2, 4}, {14, 8, 4}, {2, 2, 8}}}});
    const TriangleFilter filter = TriangleFilters(view).of(corners_of(scene, 0));
    ASSERT_FALSE(filter.is_trusted);
    EXPECT_EQ(filter.place_of({7.5, 4.5, 0.01, 0.01}), TriangleFilter::Place::unknown) << "raster (8, 5)";
    EXPECT_EQ(filter.place_of({7.5, 5.5, 0.01, 0.01}), TriangleFilter::Place::misses);
    EXPECT_EQ(filter.place_of({7.5, 3.5, 0.01, 0.01}), TriangleFilter::Place::misses);
    EXPECT_EQ(filter.place_of({7.5, 5.5, 0.8, 0.8}), TriangleFilter::Place::unknown);
    EXPECT_EQ(filter.place_of({14.5, 8.5, 0.1, 0.1}), TriangleFilter::Place::misses) << "beyond its end";
}

TEST(BoundedTriangle, ClearOfThePlanesMeansNothingIsCut) {
    int clear = 0, uncut = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        CoplanarMemory memory(16);
        AdmissibleSet<Rational> set(s.around, memory);
        const ViewBounds bounds(s.view, seed % 2 ? raster_precision() : ray_precision());
        const Sight<double> any(s.view, s.x, s.y);
        for (std::size_t i = 0; i < s.around.neighbours.size(); ++i) {
            const CornersWorld& p = s.around.neighbours[i].p_world;
            const ViewedTriangle seen(bounds, any, p);
            const BoundedTriangle triangle(bounds, s.view.camera, seen);
            const TriangleFilter filter = TriangleFilters(s.view).of(p);
            const Around square{double(s.x), double(s.y), s.around.eps_px, s.around.eps_px};
            if (!triangle.is_uncut(filter, square)) continue;
            ++uncut;
            clear += triangle.is_clear_of_planes(filter, square);
            Neighbourhood one{s.view, s.x, s.y, s.around.eps_px, {}};
            one.neighbours.push_back(neighbour_of(any, triangle.of_view));
            ASSERT_FALSE(AdmissibleSet<Rational>(one, memory).is_clipped(0));
        }
    }
    EXPECT_GT(clear, 100);
    EXPECT_GT(uncut, clear);
}

}  // namespace
}  // namespace zproof
