/// The whole judge beside a slow one that asks every pixel by itself, and what options may change of a
/// verdict.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/adjudicate/unproven_pixels.h"
#include "compare/admissible/admissibility.h"
#include "compare/admissible/depth_rule.h"
#include "compare/agree/agree.h"
#include "compare/judge.h"
#include "random_surroundings.h"
#include "test_scene.h"
#include "tests/support/same_verdict.h"

namespace zproof {
namespace {

/// The depth at which a triangle is seen at a pixel's centre, or would be.
double true_depth(const View& view, int x, int y, const CornersWorld& p_world) {
    const auto image = image_of(ViewRay<double>(view, x, y), corners<double>(p_world));
    if (!image) return 4;
    const double inverse_depth = image->inverse_depth.c;
    return view.camera.projection == Projection::perspective ? 1 / inverse_depth : -inverse_depth;
}

/// Runs of pixels that show a triangle of the scene, nothing, or what is none, most at the right depth or
/// nearly so.
void show_runs(Frame& frame, Rng& rng, const View& view, const Scene& scene) {
    const int count = int(scene.triangles.size());
    int shown = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            if (rng.below(6) == 0) shown = rng.below(count + 1);
            if (shown == count) {
                if (rng.below(30) == 0) answer(frame, x, y, std::uint32_t(count), 8);
                continue;  // bare
            }
            const double depth = true_depth(view, x, y, corners_of(scene, std::uint32_t(shown)));
            const double off = std::ldexp(rng.between(-1, 1), -26 + rng.below(7));
            answer(frame, x, y, std::uint32_t(shown), rng.below(60) ? depth * (1 + off) : -depth);
        }
}

/// Walls or a crowd that two renderers show, some pixels alike.
struct Shown {
    Rng rng;
    View view;
    Scene scene;
    Frame candidate, reference;
    Precision ours, theirs;

    explicit Shown(std::uint32_t seed)
        : rng(seed),
          view(rng.below(2)
                   ? pixel_view(rng.below(2) ? Projection::perspective : Projection::parallel, 70, 20)
                   : random_view(rng)),
          scene(view.width == 70 ? random_walls(rng, view) : random_crowd(rng, view, 8, 8)),
          candidate({view.width, view.height}),
          reference({view.width, view.height}),
          ours(raster_precision()),
          theirs(ray_precision()) {
        show_runs(candidate, rng, view, scene);
        if (rng.below(2))
            reference = candidate;
        else
            show_runs(reference, rng, view, scene);
        if (seed % 2) std::swap(ours, theirs);
    }
    Verdict verdict(const JudgeOptions& options) const {
        return judge(scene, view, {candidate, ours}, {reference, theirs}, options);
    }
};

/// Is one end open of what it may hold for its depth?
bool is_open(const View& view, const Neighbour& n) {
    const bool is_perspective = view.camera.projection == Projection::perspective;
    return std::isinf(n.greatest_inverse_depth) || std::isinf(n.least_inverse_depth) ||
           (is_perspective && n.least_inverse_depth <= 0);
}

/// One answer, from the rules alone: is it one, is its depth admissible, and is it?
struct Alone {
    bool is_invalid = false, has_depth = true;
    double error_over_bound = 0;
    Decision decision;
};

Alone alone(const Shown& s, const Frame& frame, const ViewBounds& bounds, const PixelCoord& place,
            bool differs) {
    const auto id = frame.primitive.at(place.x, place.y);
    const float z = frame.camera_depth.at(place.x, place.y);
    const bool is_none = id == PrimitiveId::none;
    Alone a;
    a.is_invalid =
        std::isnan(z) || (is_none ? z != background_depth : std::size_t(id) >= s.scene.triangles.size());
    if (a.is_invalid) return a;
    if (!is_none) {
        const CornersWorld p = corners_of(s.scene, std::uint32_t(id));
        const TriangleDepth depth(TriangleInView(s.view, bounds, p), bounds);
        const DepthCheck check = check_depth(s.view, bounds, p, depth, place, z);
        a.has_depth = check.is_admissible;
        a.error_over_bound = check.error_over_bound;
        a.is_invalid = z < 0 && !check.is_admissible;
    }
    if (a.is_invalid || !differs) return a;
    const double own = own_eps_px(s.scene, s.view, bounds, place, id);
    const Neighbourhood around = surroundings(s.scene, s.view, bounds, place, own);
    a.decision = decide(around, id);
    const auto answer = around.index_of(id);
    const bool rests_on_depth = a.decision.admissibility == Admissibility::tied ||
                                (answer && is_open(s.view, around.neighbours[*answer]));
    if (is_admissible(a.decision.admissibility) && rests_on_depth)
        a.has_depth &= may_lie_at(bounds.compared_at(z).greatest, around, id).may_lie_there;
    return a;
}

PixelClass class_of(const Alone& ours, const Alone& theirs, bool differs) {
    const Admissibility a = ours.decision.admissibility, b = theirs.decision.admissibility;
    if (ours.is_invalid) return PixelClass::invalid;
    if (!is_admissible(a)) return class_of(a, b);
    if (!ours.has_depth) return PixelClass::wrong_depth;
    if (theirs.is_invalid || !theirs.has_depth || !is_admissible(b)) return PixelClass::reference_wrong;
    return differs ? class_of(a, b) : PixelClass::agree;
}

TEST(Judge, SaysOfEveryPixelWhatTheRulesSayOfItByItself) {
    ClassCounts said{};
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const Shown s(seed);
        const ViewBounds ours(s.view, s.ours), theirs(s.view, s.theirs);
        const Verdict verdict = s.verdict({});
        const FramePair pair{
            s.scene, s.view, {s.view, {s.candidate, s.ours}}, {s.view, {s.reference, s.theirs}}};
        const std::vector<UndecidedPixel> undecided =
            find_agreement(pair, find_unproven_pixels(pair), nullptr).undecided;
        BoundRecord candidate, reference;
        std::uint64_t differing = 0, asked = 0, reference_defects = 0;
        for (int y = 0; y < s.view.height; ++y)
            for (int x = 0; x < s.view.width; ++x) {
                const PrimitiveId shown = s.candidate.primitive.at(x, y);
                const bool differs = shown != s.reference.primitive.at(x, y);
                const auto listed = std::ranges::find(undecided, PixelCoord{x, y}, &UndecidedPixel::place);
                const bool is_asked = listed != undecided.end() && listed->is_id_undecided;
                const Alone a = alone(s, s.candidate, ours, {x, y}, is_asked),
                            b = alone(s, s.reference, theirs, {x, y}, differs);
                const PixelClass expected = class_of(a, b, differs);
                ASSERT_EQ(name_of(verdict.classes.at(x, y)), name_of(expected)) << x << ' ' << y;
                ++said[std::size_t(expected)];
                differing += differs;
                asked += differs || (is_asked && !a.is_invalid);
                reference_defects +=
                    b.is_invalid || !b.has_depth || (differs && !is_admissible(b.decision.admissibility));
                if (differs || a.is_invalid || b.is_invalid || shown == PrimitiveId::none) continue;
                count(candidate, a.error_over_bound);
                count(reference, b.error_over_bound);
            }
        EXPECT_GE(verdict.adjudicated, differing) << "what is truly there is not adjudicated";
        EXPECT_LE(verdict.adjudicated, asked);
        EXPECT_EQ(verdict.reference_defects, reference_defects);
        EXPECT_EQ(verdict.candidate_depth, candidate);
        EXPECT_EQ(verdict.reference_depth, reference);
        if (HasFailure()) return;
    }
    for (const PixelClass c :
         {PixelClass::agree, PixelClass::depth_tie, PixelClass::reference_wrong, PixelClass::wrong_depth,
          PixelClass::hole, PixelClass::outside, PixelClass::hidden, PixelClass::invalid})
        EXPECT_GT(said[std::size_t(c)], 50u) << name_of(c);
}

TEST(JudgeOptions, ChangeNoClassCountOrRecord) {
    using enum JudgeOptions::Findings;
    using enum JudgeOptions::Errors;
    std::size_t defects_found = 0, differences_found = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const Shown s(seed);
        const Verdict plain = s.verdict({}), all = s.verdict(full_detail),
                      with_maps = s.verdict({defects, maps}),
                      with_findings = s.verdict({differences, records});
        for (const Verdict* other : {&all, &with_maps, &with_findings}) expect_same_counts(*other, plain);
        EXPECT_TRUE(std::ranges::equal(with_maps.findings, plain.findings, same_finding));
        EXPECT_TRUE(std::ranges::equal(with_findings.findings, all.findings, same_finding));
        EXPECT_TRUE(std::ranges::equal(plain.findings, defects_among(all.findings), same_finding));
        EXPECT_TRUE(!plain.errors && !with_findings.errors && with_maps.errors && all.errors);
        defects_found += plain.findings.size(), differences_found += all.findings.size();
    }
    EXPECT_GT(defects_found, 1000u);
    EXPECT_GT(differences_found, defects_found + 100);
}

TEST(JudgeOptions, ListWhatWasAskedForInRasterOrder) {
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const Shown s(seed);
        const Verdict verdict = s.verdict(full_detail);
        std::vector<PixelCoord> expected, found;
        for (int y = 0; y < s.view.height; ++y)
            for (int x = 0; x < s.view.width; ++x)
                if (verdict.classes.at(x, y) != PixelClass::agree) expected.push_back({x, y});
        for (const Finding& f : verdict.findings) {
            found.push_back({f.x, f.y});
            EXPECT_EQ(f.verdict, verdict.classes.at(f.x, f.y));
            EXPECT_EQ(f.candidate.primitive, s.candidate.primitive.at(f.x, f.y));
            EXPECT_EQ(f.reference.primitive, s.reference.primitive.at(f.x, f.y));
        }
        EXPECT_EQ(found, expected);
        for (const Finding& f : s.verdict({}).findings) EXPECT_FALSE(passes(f.verdict));
    }
}

TEST(JudgeOptions, DoNotDependOnTheNumberOfThreads) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const Shown s(seed);
        const Verdict alone = tbb::task_arena(1).execute([&] { return s.verdict(full_detail); });
        const Verdict together = tbb::task_arena(2).execute([&] { return s.verdict(full_detail); });
        expect_same_counts(alone, together);
        EXPECT_TRUE(std::ranges::equal(alone.findings, together.findings, same_finding));
    }
}

TEST(JudgeOptions, NoneAdmitsFramesOfAnotherSize) {
    const TestScene t(Projection::parallel, 4, 4, {wall(4)});
    const Frame wider({5, 4}), lower({4, 3});
    const RenderedFrame right{t.candidate, t.candidate_precision};
    for (const JudgeOptions& options : {JudgeOptions{}, full_detail})
        for (const Frame* wrong : {&wider, &lower}) {
            const RenderedFrame other{*wrong, t.candidate_precision};
            EXPECT_THROW(judge(t.scene, t.view, other, right, options), std::invalid_argument);
            EXPECT_THROW(judge(t.scene, t.view, right, other, options), std::invalid_argument);
        }
}

}  // namespace
}  // namespace zproof
