/// Promises from both sides: a rasterizer that computes as it declares has no defect on the whole suite, and
/// one that declares another arithmetic than its own has some.
#include <gtest/gtest.h>

#include "compare/judge.h"
#include "oracle/embree.h"
#include "scenes/random_scenes.h"
#include "scenes/suite.h"
#include "tests/precision/emulated_rasterizer.h"

namespace zproof {
namespace {

constexpr RasterPrecision world_reversed{.depth_buffer = DepthBuffer::reversed_z,
                                         .depth_interpolation = DepthInterpolation::plane};
constexpr RasterPrecision opengl_24bit{.clipping = Clipping::view_volume,
                                       .depth_buffer = DepthBuffer::standard_z,
                                       .depth_format = DepthFormat::unorm24,
                                       .clip_range = ClipRange::minus_one_to_one,
                                       .matrix_far = MatrixFar::finite,
                                       .depth_interpolation = DepthInterpolation::plane};
constexpr RasterPrecision homogeneous{
    .snap = Snap::none, .edge_functions = EdgeFunctions::homogeneous, .watertight = false};

RasterPrecision with(RasterPrecision precision, auto RasterPrecision::*key, auto value) {
    precision.*key = value;
    return precision;
}

struct Declared {
    std::string name;
    RasterPrecision precision;
};

/// Weights of corners that do not snap, and rounded edge functions.
constexpr RasterPrecision software{.snap = Snap::none,
                                   .edge_functions = EdgeFunctions::from_corner,
                                   .watertight = false,
                                   .depth_roundings = 4};

/// Edges by coefficients, the third weight from the others, and z cut to 24 bits.
RasterPrecision cut_z() {
    RasterPrecision p = opengl_24bit;
    p.snap = Snap::none;
    p.edge_functions = EdgeFunctions::window_coefficients;
    p.third_weight = ThirdWeight::remainder;
    p.watertight = false;
    p.depth_rounding = DepthRounding::truncate;
    p.depth_interpolation = DepthInterpolation::barycentrics;
    return p;
}

/// Everything in float64 but the frame's depth.
constexpr RasterPrecision wide{.transform = Arithmetic::float64,
                               .snap = Snap::none,
                               .edge_functions = EdgeFunctions::window_coefficients,
                               .edge_arithmetic = Arithmetic::float64,
                               .watertight = false,
                               .depth_buffer = DepthBuffer::standard_z,
                               .depth_format = DepthFormat::float64,
                               .clip_range = ClipRange::minus_one_to_one,
                               .matrix_far = MatrixFar::finite,
                               .interpolation = Arithmetic::float64,
                               .depth_roundings = 1};

RasterPrecision webgl() {
    RasterPrecision p = opengl_24bit;
    p.matrices = 2;
    p.depth_roundings = 4;
    p.shown_depth = ShownDepth::varying;
    return p;
}

RasterPrecision direct3d() {
    RasterPrecision p = opengl_24bit;
    p.clipping = Clipping::guard_band;
    p.clip_range = ClipRange::zero_to_one;
    return p;
}

std::vector<Declared> declarations() {
    using P = RasterPrecision;
    return {{"world_reversed", world_reversed},
            {"opengl_24bit", opengl_24bit},
            {"direct3d", direct3d()},
            {"webgl", webgl()},
            {"unorm16", with(opengl_24bit, &P::depth_format, DepthFormat::unorm16)},
            {"unorm32", with(direct3d(), &P::depth_format, DepthFormat::unorm32)},
            {"three_matrices", with(P{}, &P::matrices, 3)},
            {"standard_weights", with(direct3d(), &P::depth_interpolation, DepthInterpolation::barycentrics)},
            {"tolerant", with(software, &P::barycentric_tolerance, 1e-3)},
            {"areas", with(with(software, &P::least_area_px2, 1e-4), &P::area_epsilon_px2, 1e-4)},
            {"homogeneous", homogeneous},
            {"coefficients", with(software, &P::edge_functions, EdgeFunctions::window_coefficients)},
            {"remainder", with(software, &P::third_weight, ThirdWeight::remainder)},
            {"cut_z", cut_z()},
            {"nearest_z", with(direct3d(), &P::depth_rounding, DepthRounding::nearest)},
            {"wide", wide},
            {"linearized", with(world_reversed, &P::linearization, Arithmetic::float32)}};
}

/// A suite scene's views, and what Embree sees in them.
class Pictures {
  public:
    Pictures(const std::string& scene, int width, int height)
        : loaded_(generate_suite_scene(scene, width, height)) {
        const oracle::Embree embree(loaded_.scene);
        for (const View& view : loaded_.views) references_.push_back(embree.trace(view));
    }

    /// Over all views, of a rasterizer that computes by `own` and declares `declared`.
    std::uint64_t defects_of(const RasterPrecision& own, const RasterPrecision& declared) const {
        std::uint64_t defects = 0;
        for (std::size_t i = 0; i < loaded_.views.size(); ++i) {
            const Frame frame = emulate(own, loaded_.scene, loaded_.views[i]);
            defects += defect_count(judge(loaded_.scene, loaded_.views[i], {frame, declared},
                                          {references_[i], oracle::embree_precision()}));
        }
        return defects;
    }

  private:
    Loaded loaded_;
    std::vector<Frame> references_;
};

class EverySuiteScene : public testing::TestWithParam<std::string> {};

TEST_P(EverySuiteScene, HoldsNoDefectOfAnHonestDeclaration) {
    const Pictures pictures(GetParam(), 64, 36);
    for (const auto& [name, precision] : declarations())
        EXPECT_EQ(pictures.defects_of(precision, precision), 0u) << name;
}

/// A rasterizer, what it declares instead, and where that shows.
struct Misdeclared {
    std::string name, scene;
    RasterPrecision own, declared;
};

std::vector<Misdeclared> misdeclarations() {
    using P = RasterPrecision;
    const P fixed16 = with(opengl_24bit, &P::depth_format, DepthFormat::unorm16);
    const P wide_reversed = with(world_reversed, &P::clip_range, ClipRange::minus_one_to_one);
    const P tolerant = with(software, &P::barycentric_tolerance, 1e-2);
    const P of_area = with(software, &P::area_epsilon_px2, 1e-2);
    const P own_least = with(software, &P::least_area_px2, 1.0);
    const P truncating = with(P{}, &P::snap, Snap::truncate);
    return {
        {"ReversedForStandard", "depth_range", opengl_24bit, world_reversed},
        {"UnormOf24ForOf16", "depth_range", fixed16, opengl_24bit},
        {"ZeroToOneForMinusOneToOne", "depth_range", wide_reversed, world_reversed},
        {"VaryingForBuffer", "depth_range", fixed16, with(fixed16, &P::shown_depth, ShownDepth::varying)},
        {"EyeForWorld", "far_from_origin", P{}, with(P{}, &P::origin, Origin::eye)},
        {"Float64ForFloat32", "far_from_origin", P{}, with(P{}, &P::transform, Arithmetic::float64)},
        {"FewerBits", "room", with(P{}, &P::subpixel_bits, 4), P{}},
        {"NearestForTruncating", "room", truncating, P{}},
        {"InsideForTolerant", "room", tolerant, software},
        {"NoEpsilon", "room", of_area, software},
        {"AllDrawn", "million_triangles", own_least, software},
        {"CornersForCoefficients", "depth_range",
         with(software, &P::edge_functions, EdgeFunctions::window_coefficients), software},
        {"NearestForCutZ", "depth_range", with(fixed16, &P::depth_rounding, DepthRounding::truncate),
         with(fixed16, &P::depth_rounding, DepthRounding::nearest)},
        {"CutZForNearest", "depth_range", with(fixed16, &P::depth_rounding, DepthRounding::nearest),
         with(fixed16, &P::depth_rounding, DepthRounding::truncate)},
        {"Float64ForFloat32Z", "depth_range", with(wide, &P::depth_format, DepthFormat::float32), wide},
        {"CornersForHomogeneous", "slivers", homogeneous,
         with(homogeneous, &P::edge_arithmetic, Arithmetic::float64)},
        {"WeightsForPlane", "slivers", with(P{}, &P::depth_interpolation, DepthInterpolation::plane), P{}}};
}

class EveryMisdeclaration : public testing::TestWithParam<Misdeclared> {};

TEST_P(EveryMisdeclaration, HasDefects) {
    const auto& [name, scene, own, declared] = GetParam();
    EXPECT_GT(Pictures(scene, 128, 72).defects_of(own, declared), 0u);
}

INSTANTIATE_TEST_SUITE_P(Declared, EveryMisdeclaration, testing::ValuesIn(misdeclarations()),
                         [](const auto& one) { return one.param.name; });

/// Scenes of which a part lies behind the eye of a parallel view.
TEST(NothingBehindTheEye, IsKeptByWhoDrawsNothingThereAndByNobodyElse) {
    RasterPrecision ends = software, whole = software;
    ends.nothing_behind_the_eye = true;
    std::uint64_t views = 0, defects_of_whole = 0, defects_of_ends = 0;
    for (const RandomKind& kind : random_kinds())
        for (std::uint64_t number = 0; number < 24; ++number) {
            const Loaded loaded = generate({std::string(kind.name), 60, number});
            const View& view = loaded.views.front();
            if (!(view.camera.near_depth < 0)) continue;
            SCOPED_TRACE(loaded.scene.name);
            ++views;
            const Frame reference = oracle::Embree(loaded.scene).trace(view);
            const auto defects = [&](const RasterPrecision& own, const RasterPrecision& declared) {
                const Frame frame = emulate(own, loaded.scene, view);
                return defect_count(
                    judge(loaded.scene, view, {frame, declared}, {reference, oracle::embree_precision()}));
            };
            EXPECT_EQ(defects(whole, whole), 0u);
            EXPECT_EQ(defects(ends, ends), 0u);
            defects_of_ends += defects(ends, whole);
            defects_of_whole += defects(whole, ends);
        }
    EXPECT_GT(views, 20u);
    EXPECT_GT(defects_of_ends, 0u) << "who draws nothing there and does not say so";
    EXPECT_GT(defects_of_whole, 0u) << "who says so and draws it";
}

std::vector<std::string> suite_names() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Suite, EverySuiteScene, testing::ValuesIn(suite_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
