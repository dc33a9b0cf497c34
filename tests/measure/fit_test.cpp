// The least promise that explains a frame: errors of known size are planted and must be found again.
#include "measure/fit/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compare/judge.h"
#include "measure/fit/verification.h"
#include "oracle/embree.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof::measure {
namespace {

/// One unit of the plane is one pixel; y runs down as in the image.
View pixel_view(int width, int height) {
    View view{.name = "pixels", .camera = {}, .width = width, .height = height};
    view.camera.projection = Projection::parallel;
    view.camera.window = {.left = 0, .right = double(width), .bottom = -double(height), .top = 0};
    view.camera.near_depth = 0.25;
    view.camera.far_depth = 64;
    return view;
}

struct Corner {
    double x, y, depth;
};
using Triangle = std::array<Corner, 3>;

Scene scene_of(const std::vector<Triangle>& triangles) {
    Scene scene;
    for (const Triangle& triangle : triangles) {
        const auto first = std::uint32_t(scene.vertices.position_world.size());
        for (const Corner& c : triangle)
            scene.vertices.position_world.push_back(glm::vec3(glm::dvec3(c.x, -c.y, -c.depth)));
        scene.triangles.emplace_back(first, first + 1, first + 2);
    }
    return scene;
}

/// A triangle's place in the image, worked out here by itself.
class Region {
  public:
    explicit Region(const Triangle& t) {
        for (std::size_t i = 0; i < 3; ++i) p_[i] = {float(t[i].x), float(t[i].y)};
        const auto [ax, ay] = p_[0];
        const auto [bx, by] = p_[1];
        const auto [cx, cy] = p_[2];
        if ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0) std::swap(p_[1], p_[2]);
    }
    bool holds(double x, double y) const { return clearance(x, y) >= 0; }
    /// Half-side of the largest square around the place that lies within; negative outside.
    double clearance(double x, double y) const {
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [ax, ay] = p_[i];
            const auto [bx, by] = p_[(i + 1) % 3];
            const double side = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
            least = std::min(least, side / (std::abs(bx - ax) + std::abs(by - ay)));
        }
        return least;
    }
    /// Half-side of the least square around the place that meets it: the least along its edges, by search.
    double distance(double x, double y) const {
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
            double low = 0, high = 1;  // the distance along an edge is convex
            for (int k = 0; k < 200; ++k) {
                const double a = low + (high - low) / 3, b = high - (high - low) / 3;
                (from(i, a, x, y) < from(i, b, x, y) ? high : low) =
                    from(i, a, x, y) < from(i, b, x, y) ? b : a;
            }
            least = std::min(least, from(i, low, x, y));
        }
        return least;
    }

  private:
    double from(std::size_t edge, double t, double x, double y) const {
        const auto [ax, ay] = p_[edge];
        const auto [bx, by] = p_[(edge + 1) % 3];
        return std::max(std::abs(ax + t * (bx - ax) - x), std::abs(ay + t * (by - ay) - y));
    }

    std::array<std::pair<double, double>, 3> p_;
};

Frame drawn(const View& view, const Region& shown, double depth) {
    Frame frame({view.width, view.height});
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            if (!shown.holds(x + 0.5, y + 0.5)) continue;
            frame.primitive.at(x, y) = PrimitiveId{0};
            frame.camera_depth.at(x, y) = float(depth);
        }
    return frame;
}

/// The greatest eps that a pixel of the frame needs, where one triangle is all that there is.
double needed_px(const Frame& frame, const Region& truth) {
    double needed = 0;
    for (int y = 0; y < frame.size().height; ++y)
        for (int x = 0; x < frame.size().width; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const bool shown = frame.primitive.at(x, y) != PrimitiveId::none, holds = truth.holds(px, py);
            if (shown && !holds) needed = std::max(needed, truth.distance(px, py));
            if (!shown && holds) needed = std::max(needed, truth.clearance(px, py));
        }
    return needed;
}

Frame drawn_with_bits(const Loaded& loaded, const View& view, int bits) {
    return rasterizer::render_by({.subpixel_bits = bits}, loaded.scene, view);
}

/// A view whose window is moved to the right by so much of a pixel.
View moved(View view, double dx_px) {
    Window& window = view.camera.window;
    const double dx = dx_px * (window.right - window.left) / view.width;
    window.left += dx;
    window.right += dx;
    return view;
}

TEST(Fit, FindsWhatADisplacedTriangleNeeds) {
    const View view = pixel_view(24, 24);
    std::mt19937 random{7};
    std::uniform_real_distribution<double> place{0, 24}, shift{-0.5, 0.5};
    int displaced = 0;
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        Triangle truth{{{place(random), place(random), 4},
                        {place(random), place(random), 4},
                        {place(random), place(random), 4}}};
        Triangle shown = truth;
        const double scale = std::exp2(-round / 6);
        for (Corner& c : shown) {
            c.x += scale * shift(random);
            c.y += scale * shift(random);
        }
        const Frame frame = drawn(view, Region(shown), 4);
        const double needed = needed_px(frame, Region(truth));
        const ViewFit found = fit(scene_of({truth}), view, frame);
        EXPECT_TRUE(found.is_verified);
        EXPECT_EQ(found.defects, 0u);
        if (needed < 0x1p-29) continue;
        ++displaced;
        EXPECT_LE(found.eps.px.low, needed * (1 + 1e-9));
        EXPECT_GE(found.eps.px.high, needed * (1 - 1e-9));
        EXPECT_LE(found.eps.px.high, 1.02 * found.eps.px.low);
        EXPECT_FALSE(found.eps.decided_by.empty());
    }
    EXPECT_GE(displaced, 20);
}

TEST(Fit, RecoversSubpixelBits) {
    const Loaded room = generate_suite_scene("room", 256, 144);
    for (int bits = 4; bits <= 12; ++bits) {
        SCOPED_TRACE(bits);
        double low = 0;
        for (const View& view : room.views) {
            const ViewFit found = fit(room.scene, view, drawn_with_bits(room, view, bits));
            EXPECT_TRUE(found.is_verified) << view.name;
            low = std::max(low, found.eps.px.low);
        }
        const double most = std::exp2(-bits - 1);
        EXPECT_LE(low, most * (1 + 1e-6));  // the transform is float64
        if (bits > 8) continue;             // few pixels of so small a view turn
        EXPECT_GE(low, most / 8);
    }
}

TEST(Fit, DepthErrorsThatDisplacementMakesGoWhereItIsGranted) {
    const Loaded room = generate_suite_scene("room", 256, 144);
    const ViewFit found = fit(room.scene, room.views.front(), drawn_with_bits(room, room.views.front(), 6));
    ASSERT_EQ(found.trade.size(), 3u);
    EXPECT_GE(found.trade.back().eps_px, 0x1p-7);
    EXPECT_LT(found.trade.back().error.ulps, 2);
    for (std::size_t i = 1; i < found.trade.size(); ++i)
        EXPECT_LE(found.trade[i].error.relative, found.trade[i - 1].error.relative);
}

TEST(Fit, RecoversABiasOfAThousandthOfAPixel) {
    const Loaded room = generate_suite_scene("room", 480, 270);
    const View& view = room.views.front();
    const oracle::Embree embree(room.scene);
    const ViewFit found = fit(room.scene, view, embree.trace(moved(view, 1e-3)));
    EXPECT_LE(found.eps.px.low, 1e-3 + 2e-5);
    EXPECT_GE(found.eps.px.high, 0.8e-3);
    EXPECT_TRUE(found.is_verified);
}

/// A triangle on the plane depth = 4 + x / 8 + y / 16, and a frame of it that is as right as float32 can be.
Frame drawn_slanted(const View& view, Triangle& triangle) {
    const auto depth = [](double x, double y) { return 4 + x / 8 + y / 16; };
    for (Corner& c : triangle) c.depth = depth(c.x, c.y);
    Frame frame = drawn(view, Region(triangle), 0);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            if (frame.primitive.at(x, y) != PrimitiveId::none)
                frame.camera_depth.at(x, y) = float(depth(x + 0.5, y + 0.5));
    return frame;
}

TEST(Fit, RecoversDepthsThatAreUlpsOff) {
    const View view = pixel_view(24, 24);
    Triangle truth{{{1, 1, 0}, {23, 2, 0}, {3, 22, 0}}};
    const Frame exact = drawn_slanted(view, truth);
    for (const int ulps : {1, 2, 5, 64}) {
        SCOPED_TRACE(ulps);
        Frame frame = exact;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                for (int k = 0; k < ulps; ++k)
                    frame.camera_depth.at(x, y) =
                        std::nextafter(frame.camera_depth.at(x, y), background_depth);
        const ViewFit found = fit(scene_of({truth}), view, frame);
        EXPECT_NEAR(found.depth.error.ulps, ulps, 0.51);
        EXPECT_NEAR(found.depth.error.relative, ulps * 0x1p-23, ulps * 0x1p-25 + 0x1p-25);
        EXPECT_NEAR(found.depth.error.of_range, ulps * 0x1p-21 / 63.75, 0x1p-22 / 63);
        EXPECT_TRUE(found.is_verified);
        EXPECT_EQ(found.defects, 0u);
    }
}

/// |d - t| is 0.01, 0.5 or 2 times t: what was planted is told.
TEST(Fit, GivesBackAPlantedShareOfTheDepth) {
    const View view = pixel_view(24, 24);
    const Triangle truth{{{1, 1, 4}, {23, 2, 4}, {3, 22, 4}}};
    const std::vector<std::pair<double, double>> planted{{1.01, 0.01}, {1.5, 0.5}, {2, 1},
                                                         {3, 2},       {0.5, 0.5}, {0.99, 0.01}};
    for (const auto& [factor, share] : planted) {
        SCOPED_TRACE(factor);
        const ViewFit found = fit(scene_of({truth}), view, drawn(view, Region(truth), 4 * factor));
        EXPECT_NEAR(found.depth.error.relative, share, 1e-6);
        EXPECT_GE(found.promise.depth_relative, found.depth.error.relative);
        EXPECT_LE(found.promise.depth_relative, 1.011 * share) << "rounded up to three digits";
        EXPECT_TRUE(found.is_verified);
        EXPECT_EQ(found.defects, 0u);
    }
}

TEST(Fit, EmbreeNeedsLessThanATenThousandthOfAPixel) {
    for (const char* name : {"room", "slivers"}) {
        const Loaded loaded = generate_suite_scene(name, 160, 90);
        const oracle::Embree embree(loaded.scene);
        for (const View& view : loaded.views) {
            SCOPED_TRACE(name + ("/" + view.name));
            const ViewFit found = fit(loaded.scene, view, embree.trace(view));
            EXPECT_LT(found.eps.px.high, 1e-4);
            EXPECT_TRUE(found.is_verified);
        }
    }
}

TEST(Fit, AnExactFrameNeedsNothing) {
    const View view = pixel_view(8, 8);
    const Triangle truth{{{1, 1, 4}, {7, 1, 4}, {1, 7, 4}}};
    const ViewFit found = fit(scene_of({truth}), view, drawn(view, Region(truth), 4));
    EXPECT_EQ(found.eps.found_px(), 0);
    EXPECT_EQ(found.eps_px.at(least_octave), 64u);
    EXPECT_EQ(found.depth.error.relative, 0);
    EXPECT_TRUE(found.is_verified);
}

/// Two triangles that share a diagonal, which passes beside the centre of (3, 4).
std::vector<Triangle> square_of_two() {
    const Corner a{0, 0.25, 4}, b{8, 8.25, 4};
    return {{{a, b, {-64, 64, 4}}}, {{a, {64, -64, 4}, b}}, {{{64, -64, 4}, {64, 64, 4}, b}}};
}

TEST(Fit, AGapBetweenTrianglesThatShareAnEdgeIsToldAsOne) {
    const View view = pixel_view(8, 8);
    const std::vector<Triangle> mesh = square_of_two();
    Frame frame({8, 8});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (std::uint32_t i = 0; i < mesh.size(); ++i)
                if (Region(mesh[i]).holds(x + 0.5, y + 0.5)) {
                    frame.primitive.at(x, y) = PrimitiveId{i};
                    frame.camera_depth.at(x, y) = 4;
                }
    ASSERT_EQ(fit(scene_of(mesh), view, frame).gaps, 0u);
    frame.primitive.at(4, 4) = PrimitiveId::none;
    frame.camera_depth.at(4, 4) = background_depth;
    const ViewFit found = fit(scene_of(mesh), view, frame);
    EXPECT_EQ(found.gaps, 1u);
    EXPECT_FALSE(found.promise.watertight);
    EXPECT_NEAR(found.eps.px.high, 0.125, 0.125 / 40);  // the triangle moves off the centre
    EXPECT_TRUE(found.is_verified);
}

TEST(Fit, PixelsWithoutAnAnswerAreLeftOutAndCountAsDefects) {
    const View view = pixel_view(8, 8);
    const Triangle truth{{{1, 1, 4}, {7, 1, 4}, {1, 7, 4}}};
    Frame frame = drawn(view, Region(truth), 4);
    frame.primitive.at(2, 2) = PrimitiveId{9};
    const ViewFit found = fit(scene_of({truth}), view, frame);
    ASSERT_EQ(found.left_out.size(), 1u);
    EXPECT_EQ(found.left_out[0].reason, LeftOut::Reason::no_answer);
    EXPECT_EQ(found.left_out[0].pixel, (PixelCoord{2, 2}));
    EXPECT_EQ(found.defects, 1u);
    EXPECT_TRUE(found.is_verified);
}

TEST(Fit, ALonePixelStandsApartFromTheOthers) {
    const Loaded room = generate_suite_scene("room", 480, 270);
    const View& view = room.views.front();
    Frame frame = rasterizer::render(room.scene, view);
    const ViewFit before = fit(room.scene, view, frame);
    ASSERT_TRUE(before.left_out.empty());
    ASSERT_GT(before.eps_px.above(least_octave), 2u);
    frame.primitive.at(240, 135) = PrimitiveId::none;
    frame.camera_depth.at(240, 135) = background_depth;
    const ViewFit found = fit(room.scene, view, frame);
    EXPECT_EQ(found.eps.px.high, before.eps.px.high);
    ASSERT_EQ(found.left_out.size(), 1u);
    EXPECT_EQ(found.left_out[0].pixel, (PixelCoord{240, 135}));
    EXPECT_EQ(found.defects, 1u);
    EXPECT_TRUE(found.is_verified);
}

TEST(Fit, NoLesserEpsHasTheJudgesApproval) {
    const Loaded room = generate_suite_scene("room", 256, 144);
    const View& view = room.views.front();
    const Frame frame = drawn_with_bits(room, view, 5);
    const ViewFit found = fit(room.scene, view, frame);
    BoundedPrecision less = found.promise;
    EXPECT_TRUE(defects_under(less, room.scene, view, frame).empty());
    less.eps_px = found.eps.px.low / 2.1;  // by seams of the scene the judge lets half of it pass
    EXPECT_FALSE(defects_under(less, room.scene, view, frame).empty());
}

}  // namespace
}  // namespace zproof::measure
