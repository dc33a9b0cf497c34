/// The first tier must leave undecided what is not certain pixel by pixel, and nothing else.
#include "compare/agree/agree.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <limits>

#include "compare/adjudicate/unproven_pixels.h"
#include "compare/agree/depth_errors.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

FramePair pair_of(const TestScene& t) {
    return {t.scene,
            t.view,
            {t.view, {t.candidate, t.candidate_precision}},
            {t.view, {t.reference, t.reference_precision}}};
}

/// One answer by itself: is it certain, and what is its error?
struct Alone {
    double error = undecided_error;
    float in_map = nan;
};
Alone alone(const FramePair& pair, const Frame& frame, const ViewBounds& bounds, int x, int y) {
    const auto id = frame.primitive.at(x, y);
    const float z = frame.camera_depth.at(x, y);
    if (id == PrimitiveId::none) return {z == background_depth ? 0 : undecided_error, nan};
    if (std::size_t(id) >= pair.scene.triangles.size()) return {};
    const TriangleInView triangle(pair.view, bounds, corners_of(pair.scene, std::uint32_t(id)));
    const TriangleDepth depth(triangle, bounds);
    const DepthBound bound = depth.at(x, y);
    const bool is_certain = depth.has_plane() && depth.certainly_holds(bound, z);
    return {is_certain ? error_over_bound(bound, z) : undecided_error, float(error_over_bound(bound, z))};
}

bool is_in_raster_order(const UndecidedPixel& a, const UndecidedPixel& b) {
    return a.place.y != b.place.y ? a.place.y < b.place.y : a.place.x < b.place.x;
}

void expect_same(const Plane<float>& map, const Plane<float>& expected) {
    for (std::size_t i = 0; i < map.pixels().size(); ++i) {
        const float found = map.pixels()[i], right = expected.pixels()[i];
        ASSERT_TRUE(found == right || (std::isnan(found) && std::isnan(right)))
            << i << ": " << found << ", not " << right;
    }
}

struct Tried {
    int undecided = 0, in_id_alone = 0, agreed = 0;
};

/// The same whether error maps are asked for or not.
Agreement sorted_agreement(const FramePair& pair, ErrorMaps* maps) {
    Agreement found = find_agreement(pair, find_unproven_pixels(pair), maps);
    std::ranges::sort(found.undecided, is_in_raster_order);
    return found;
}

void expect_same(const Agreement& found, const Agreement& expected) {
    ASSERT_EQ(found.undecided.size(), expected.undecided.size());
    for (std::size_t i = 0; i < expected.undecided.size(); ++i) {
        ASSERT_EQ(found.undecided[i].place, expected.undecided[i].place);
        ASSERT_EQ(found.undecided[i].are_depths_admissible, expected.undecided[i].are_depths_admissible);
        ASSERT_EQ(found.undecided[i].is_id_undecided, expected.undecided[i].is_id_undecided);
    }
    EXPECT_EQ(found.candidate_depth, expected.candidate_depth);
    EXPECT_EQ(found.reference_depth, expected.reference_depth);
}

/// Holds what the tier finds against every pixel by itself.
void try_frames(const TestScene& t, Tried& tried) {
    const FramePair pair = pair_of(t);
    const Plane<std::uint8_t> unproven = find_unproven_pixels(pair);
    const Resolution size{t.view.width, t.view.height};
    ErrorMaps maps{Plane<float>(size, 77), Plane<float>(size, 77)}, expected_maps = maps;
    Agreement expected;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const BoundedFrame &candidate = pair.candidate, &reference = pair.reference;
            const Alone a = alone(pair, candidate.frame, candidate.bounds, x, y),
                        b = alone(pair, reference.frame, reference.bounds, x, y);
            const bool ids_differ = t.candidate.primitive.at(x, y) != t.reference.primitive.at(x, y),
                       is_background = t.reference.primitive.at(x, y) == PrimitiveId::none;
            const bool is_another_depth =
                b.error < 0 ||
                (a.error >= 0 && alone(pair, reference.frame, candidate.bounds, x, y).error < 0);
            const bool is_proof =
                !unproven.at(x, y) && (is_background || !is_another_depth);
            expected_maps.candidate.at(x, y) = a.in_map;
            expected_maps.reference.at(x, y) = b.in_map;
            const bool is_known = std::size_t(t.reference.primitive.at(x, y)) < t.scene.triangles.size();
            const bool is_undecided = ids_differ || (!is_proof && (is_known || unproven.at(x, y))),
                       are_certain = a.error >= 0 && b.error >= 0;
            if (!are_certain || is_undecided) {
                expected.undecided.push_back({{x, y}, are_certain, is_undecided});
                ++tried.undecided, tried.in_id_alone += are_certain;
            }
            if (are_certain && !ids_differ && !is_background) {
                count(expected.candidate_depth, a.error);
                count(expected.reference_depth, b.error);
                ++tried.agreed;
            }
        }
    expect_same(sorted_agreement(pair, &maps), expected);
    expect_same(sorted_agreement(pair, nullptr), expected);
    expect_same(maps.candidate, expected_maps.candidate);
    expect_same(maps.reference, expected_maps.reference);
}

/// Row y shows background in both frames, but perhaps for one pixel of one of them: a triangle at infinity,
/// or a background at a depth.
void make_bare(TestScene& t, int y, Rng& rng) {
    const int width = t.view.width;
    for (int x = 0; x < width; ++x) {
        answer_background(t.candidate, x, y);
        answer_background(t.reference, x, y);
    }
    Frame& frame = rng.below(2) ? t.candidate : t.reference;
    const int x = rng.below(width), odd = rng.below(3);
    if (odd == 0) frame.primitive.at(x, y) = PrimitiveId(1);
    if (odd == 1) frame.camera_depth.at(x, y) = 4;
}

/// Walls at depths 1, 1 + 1/64 ..., a sliver that has no plane, and frames that show runs of any of them: at
/// their depth, next to it or far from it, at none, or as background and ids that are none.
TestScene random_frames(std::uint32_t seed, int width, int height, int walls, int longest_run) {
    Rng rng(seed);
    std::vector<Triangle> triangles{{{{1.5, -8, 2}, {1.5, 24, 2}, {1.5, 8, 8}}}};
    for (int i = 1; i < walls; ++i)
        triangles.push_back(
            {{{-64, -64, 1 + i / 64.0}, {4096, -64, 1 + i / 64.0}, {-64, 4096, 1 + i / 64.0}}});
    TestScene t(rng.below(2) ? Projection::perspective : Projection::parallel, width, height, triangles);
    std::uint32_t shown = 0;
    const auto answer_at = [&](Frame& frame, int x, int y) {
        const double depth = 1 + shown / 64.0;
        const float depths[] = {float(depth), std::nextafter(float(depth), 0.f), float(depth * (1 + 0x1p-12)),
                                nan};
        answer(frame, x, y, shown, depths[rng.below(30) ? rng.below(2) : 2 + rng.below(2)]);
        if (rng.below(12) == 0) answer_background(frame, x, y);
        if (rng.below(60) == 0) frame.primitive.at(x, y) = PrimitiveId::none;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (rng.below(longest_run) == 0)
                shown = std::uint32_t(rng.below(walls + 1));  // or none of the scene
            answer_at(t.candidate, x, y);
            if (rng.below(6) == 0) shown = std::uint32_t(rng.below(walls));
            answer_at(t.reference, x, y);
        }
    for (int y = rng.below(3); y < height; y += 2) make_bare(t, y, rng);
    return t;
}

TEST(Agree, LeavesUndecidedWhatIsNotCertainPixelByPixel) {
    constexpr Resolution sizes[] = {{1, 1}, {64, 16}, {63, 15}, {65, 17}, {130, 33}, {200, 5}, {3, 70}};
    Tried tried;
    for (std::uint32_t seed = 0; seed < 35; ++seed) {
        SCOPED_TRACE(seed);
        const auto [width, height] = sizes[seed % std::size(sizes)];
        try_frames(random_frames(seed, width, height, 6, 1 + int(seed % 9)), tried);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tried.agreed, 5'000);
    EXPECT_GT(tried.undecided, 5'000);
    EXPECT_GT(tried.in_id_alone, 1'000);
}

/// Every pixel of both frames shows another triangle: twice as many in a block as it has pixels.
TEST(Agree, HoldsAnyNumberOfTrianglesInABlock) {
    Tried tried;
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        SCOPED_TRACE(seed);
        try_frames(random_frames(seed, 130, 20, 4000, 1), tried);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tried.agreed, 1'000);
}

/// The triangles of one block are not those of the next: ids far apart whose places meet.
TEST(Agree, ForgetsTheTrianglesOfTheBlockBefore) {
    constexpr int width = 256, height = 16;
    TestScene t(Projection::parallel, width, height, std::vector<Triangle>(64, wall(4)));
    for (std::size_t i = 0; i < t.scene.vertices.position_world.size(); ++i)
        t.scene.vertices.position_world[i].z = -(1 + float(i / 3) / 4);  // wall i at depth 1 + i / 4
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto shown = std::uint32_t(x / 4);
            answer(t.candidate, x, y, shown, 1 + shown / 4.0);
            answer(t.reference, x, y, shown, 1 + shown / 4.0);
        }
    const Plane<std::uint8_t> all_proven(Resolution{width, height}, 0);
    const Agreement found = find_agreement(pair_of(t), all_proven, nullptr);
    EXPECT_TRUE(found.undecided.empty());
    EXPECT_EQ(found.candidate_depth.histogram[0], std::uint64_t(width * height));
}

TEST(Agree, DoesNotDependOnTheNumberOfThreads) {
    const TestScene t = random_frames(7, 300, 200, 9, 5);
    const FramePair pair = pair_of(t);
    const auto found_by = [&](int threads) {
        return tbb::task_arena(threads).execute(
            [&] { return find_agreement(pair, find_unproven_pixels(pair), nullptr); });
    };
    const Agreement one = found_by(1);
    for (const int threads : {2, 3}) {
        const Agreement other = found_by(threads);
        EXPECT_EQ(other.candidate_depth, one.candidate_depth);
        EXPECT_EQ(other.reference_depth, one.reference_depth);
        ASSERT_EQ(other.undecided.size(), one.undecided.size());
        for (std::size_t i = 0; i < one.undecided.size(); ++i) {
            ASSERT_EQ(other.undecided[i].place, one.undecided[i].place);
        }
    }
}

}  // namespace
}  // namespace zproof
