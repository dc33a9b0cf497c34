// Frames of labels, of depth alone, and of depths of a declared kind: what is wrong with what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/diagnosis/diagnosis.h"
#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/labels/labelled_frame.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/camera_depth.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

/// One view of the suite with background in it, as zproof's own rasterizer draws it.
class GivenFrame : public testing::Test {
  protected:
    Loaded loaded_ = generate_suite_scene("closed_surfaces", 160, 90);
    View view_ = loaded_.views.front();
    Frame right_ = rasterizer::render(loaded_.scene, view_);
    Frame reference_ = oracle::Embree(loaded_.scene).trace(view_);

    /// Five labels: of the triangle's index.
    TriangleLabels labels() const {
        TriangleLabels labels{.ids = "label file", .of_triangle = {}};
        for (std::size_t t = 0; t < loaded_.scene.triangles.size(); ++t)
            labels.of_triangle.push_back(std::uint32_t(t * 5 / loaded_.scene.triangles.size()));
        return labels;
    }

    static std::string told(const Explanation& e) {
        return e.name + ": " + std::to_string(e.explained) + " of " + std::to_string(e.asked) +
               ", against it " + std::to_string(e.contradicted) + " of " + std::to_string(e.checked) +
               ", spared " + std::to_string(e.saved_share);
    }

    std::string cause_of(const Frame& said, const FrameAsGiven& given) const {
        const Precision precision = rasterizer::precision();
        const Frame triangles =
            given.said ? with_triangles(loaded_.scene, view_, {said, precision}, given.said->labels,
                                        {reference_, oracle::embree_precision()})
                       : said;
        const RenderedFrame ours{triangles, precision}, theirs{reference_, oracle::embree_precision()};
        const auto diagnosis =
            diagnose(loaded_.scene, view_, ours, theirs, judge(loaded_.scene, view_, ours, theirs), given);
        if (!diagnosis) return "no defect";
        if (diagnosis->cause) return diagnosis->cause->name;
        return "none, at best " +
               (diagnosis->runners_up.empty() ? "nothing" : told(diagnosis->runners_up.front()));
    }

    std::string cause_of_labels(const std::function<std::uint32_t(std::uint32_t)>& told) const {
        const TriangleLabels labels = this->labels();
        Frame said = with_labels(right_, labels);
        for (PrimitiveId& id : said.primitive.pixels()) id = PrimitiveId(told(std::uint32_t(id)));
        return cause_of(said, {.said = SaidLabels{labels, said.primitive}});
    }

    std::string cause_of_background(float depth) const {
        const TriangleLabels none = label_triangles("none", loaded_.scene);
        Frame said = right_;
        for (float& told : said.camera_depth.pixels())
            if (told == background_depth) told = depth;
        return cause_of(said, {.said = SaidLabels{none, said.primitive}});
    }

    /// Each depth is stored as `told` says, and read by the convention.
    std::string cause_of_stored(const Convention& convention,
                                const std::function<double(double)>& told) const {
        const CameraDepth camera_depth(convention, view_);
        Frame read = right_;
        for (int y = 0; y < view_.height; ++y)
            for (int x = 0; x < view_.width; ++x) {
                float& depth = read.camera_depth.at(x, y);
                if (depth != background_depth)
                    depth = float(camera_depth(double(float(told(double(depth)))), x, y));
            }
        return cause_of(read, {.convention = convention});
    }
};

constexpr std::uint32_t nobody = 0xFFFF'FFFF;

TEST_F(GivenFrame, OfRightLabelsHasNoDefect) {
    EXPECT_EQ(cause_of_labels([](std::uint32_t label) { return label; }), "no defect");
}

TEST_F(GivenFrame, OfLabelsThatCountFromOneIsNamed) {
    EXPECT_EQ(cause_of_labels([](std::uint32_t label) { return label == nobody ? label : label + 1; }),
              "labels count from 1");
    EXPECT_EQ(cause_of_labels([](std::uint32_t label) { return label == nobody ? 0 : label + 1; }),
              "labels count from 1, and 0 is background");
}

TEST_F(GivenFrame, OfExchangedLabelsIsNamed) {
    EXPECT_EQ(cause_of_labels([](std::uint32_t label) { return label < 2 ? 1 - label : label; }),
              "labels are exchanged");
}

TEST_F(GivenFrame, OfOtherNumbersIsNamed) {
    EXPECT_EQ(
        cause_of_labels([](std::uint32_t label) { return label == nobody ? label : 1000 + 17 * label; }),
        "labels have other numbers");
}

TEST_F(GivenFrame, OfLabelsStoredAsColoursIsNamed) {
    EXPECT_EQ(cause_of_labels([](std::uint32_t label) {
                  constexpr std::array<std::uint32_t, 5> srgb{0, 13, 22, 28, 34};  // of 0 to 4 of 255
                  return label == nobody ? label : srgb[label];
              }),
              "labels went through the curve of sRGB");
}

/// As a picture of labels that was drawn twice as large and made smaller.
TEST_F(GivenFrame, OfBlendedLabelsIsNamed) {
    TriangleLabels labels = this->labels();
    for (std::uint32_t& label : labels.of_triangle) label = 20 + 50 * label;
    View large = view_;
    large.width *= 2;
    large.height *= 2;
    const Frame of_samples = with_labels(rasterizer::render(loaded_.scene, large), labels);
    Frame said = with_labels(right_, labels);
    for (int y = 0; y < view_.height; ++y)
        for (int x = 0; x < view_.width; ++x) {
            double sum = 0;
            bool is_seen = true;
            for (const int k : {0, 1, 2, 3}) {
                const PrimitiveId label = of_samples.primitive.at(2 * x + k % 2, 2 * y + k / 2);
                sum += double(std::uint32_t(label));
                is_seen &= label != PrimitiveId::none;
            }
            if (is_seen) said.primitive.at(x, y) = PrimitiveId(std::uint32_t(std::lround(sum / 4)));
        }
    EXPECT_EQ(cause_of(said, {.said = SaidLabels{labels, said.primitive}}),
              "labels are blended by antialiasing");
}

TEST_F(GivenFrame, OfDepthAloneWhoseBackgroundHasADepthIsNamed) {
    const auto far = float(view_.camera.far_depth);
    for (const float depth : {0.0f, far, -1.0f, std::nanf("")})
        EXPECT_EQ(cause_of_background(depth), "background has a depth") << depth;
}

/// Without ids the same frame is one that is shifted.
TEST_F(GivenFrame, OfDepthAloneHasNoDepthsBesideTheirIds) {
    const RenderedFrame ours{right_, rasterizer::precision()}, theirs{reference_, oracle::embree_precision()};
    const auto beside_ids = [&](const SaidLabels* said) {
        return std::ranges::count_if(
            hypotheses_of_depth({loaded_.scene, view_, ours, theirs, said}),
            [](const Hypothesis& h) { return h.cause.name.ends_with("of their ids"); });
    };
    const SaidLabels none{label_triangles("none", loaded_.scene), right_.primitive},
        five{labels(), right_.primitive};
    EXPECT_EQ(beside_ids(&none), 0);
    EXPECT_EQ(beside_ids(&five), 4);
    EXPECT_EQ(beside_ids(nullptr), 4);
}

TEST_F(GivenFrame, OfAnotherKindThanDeclaredIsNamed) {
    const double near = view_.camera.near_depth, far = view_.camera.far_depth;
    Convention window, ray, millimetres;
    window.depth_kind = DepthKind::window_z;
    ray.depth_kind = DepthKind::ray_length;
    millimetres.depth_scale = 0.001;
    const auto z = [=](double depth) { return far * (depth - near) / (depth * (far - near)); };
    EXPECT_EQ(cause_of_stored(window, [&](double depth) { return 1 - z(depth); }),
              "depth is NDC z (1 to 0, reversed)");
    EXPECT_EQ(cause_of_stored(window, [&](double depth) { return 2 * z(depth) - 1; }),
              "depth is NDC z (-1 to 1)");
    EXPECT_EQ(cause_of_stored(window, [&](double depth) { return (depth - near) / (far - near); }),
              "depth is scaled to 0 at near and 1 at far");
    EXPECT_EQ(cause_of_stored(ray, [](double depth) { return depth; }),
              "depth is along the view axis already");
    EXPECT_EQ(cause_of_stored(millimetres, [](double depth) { return depth; }),
              "depth is along the view axis already");
}

}  // namespace
}  // namespace zproof
