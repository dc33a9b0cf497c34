// Every kernel that this machine can run gives the bits of the plainest scan there is.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing.h"
#include "math/processor.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/view_setup.h"
#include "scenes/suite.h"

namespace zproof::rasterizer {
namespace {

/// A kernel without blocks, vectors or early rejection: each edge function of each pixel in 64-bit integers,
/// depth in the order of operations that docs/bounds.md counts the roundings of.
namespace plain {

void project(const VertexWork& work) noexcept {
    for (std::size_t i = 0; i < work.count; ++i) {
        const ClipVertex v = work.setup.clip_from_world(work.position_world[i]);
        const int code = outcode_of(v, work.setup.volume);
        const auto snapped = work.setup.snap(v);
        work.outcode[i] =
            std::uint8_t(code & outcode::needs_clip || snapped ? code : int(outcode::not_finite));
        work.snapped[i] = snapped.value_or(SnappedVertex{});
    }
}

/// Row by row and column by column: does the box hold its samples?
struct Span {
    int first = 1, last = 0;
};

Span samples_within(int low, int high, int pixels, const SubpixelGrid& grid) {
    Span span;
    for (int i = 0; i < pixels; ++i) {
        if (grid.sample(i) < low || grid.sample(i) > high) continue;
        if (span.last < span.first) span.first = i;
        span.last = i;
    }
    return span;
}

std::int64_t edge(SnappedPoint from, SnappedPoint to, SnappedPoint p);

PlacedLanes place(const ViewSetup& setup, const CornerLanes& lanes) noexcept {
    PlacedLanes placed{};
    for (int i = 0; i < CornerLanes::count; ++i) {
        const auto at = [&](int k) { return lanes.corner[k][i]; };
        const std::int64_t area = edge(at(0), at(1), at(2));
        const auto [left, right] = std::minmax({at(0).x, at(1).x, at(2).x});
        const auto [top, bottom] = std::minmax({at(0).y, at(1).y, at(2).y});
        const Span columns = samples_within(left, right, setup.size.width, setup.grid);
        const Span rows = samples_within(top, bottom, setup.size.height, setup.grid);
        const bool may_cover = area != 0 && columns.first <= columns.last && rows.first <= rows.last;
        const bool faces_away = may_cover && setup.facing == Facing::front && area > 0;
        placed.column0[i] = 1;
        placed.turn[i] = area < 0 ? turned : 0;
        placed.faces_away[i] = faces_away;
        if (!may_cover || faces_away) continue;
        placed.column0[i] = columns.first / tile_size, placed.column1[i] = columns.last / tile_size;
        placed.row0[i] = rows.first / tile_size, placed.row1[i] = rows.last / tile_size;
    }
    return placed;
}

void resolve(const ResolveWork& work) noexcept {
    for (int y = 0; y < work.rows; ++y)
        for (int x = 0; x < work.columns; ++x) {
            const int from = place_in_tile(x, y);
            const std::size_t to = work.stride * std::size_t(y) + std::size_t(x);
            const float inverse_depth = work.pixels.inverse_depth[from];
            work.camera_depth[to] =
                inverse_depth == nothing_seen ? background_depth : work.depth.depth_of(inverse_depth);
            work.primitive[to] = PrimitiveId{work.pixels.primitive[from]};
        }
}

struct Vertices {
    const SnappedVertex* v[3];
    std::uint32_t id;
};

Vertices at(const Triangles& triangles, std::uint32_t word) {
    const std::uint32_t place = word & ~turned;
    const bool is_piece = place >= triangles.length;
    const SnappedPiece* piece = is_piece ? triangles.pieces + (place - triangles.length) : nullptr;
    Vertices found{{}, is_piece ? std::uint32_t(piece->id) : place};
    for (int k = 0; k < 3; ++k)
        found.v[k] = is_piece ? &piece->vertex[k] : &triangles.vertices[triangles.corners[place][k]];
    if (word & turned) std::swap(found.v[1], found.v[2]);
    return found;
}

std::int64_t edge(SnappedPoint from, SnappedPoint to, SnappedPoint p) {
    return (std::int64_t{to.x} - from.x) * (std::int64_t{p.y} - from.y) -
           (std::int64_t{to.y} - from.y) * (std::int64_t{p.x} - from.x);
}

std::int64_t least(SnappedPoint from, SnappedPoint to, const TileSamples& samples) {
    const bool is_left = to.y < from.y, is_top = to.y == from.y && to.x > from.x;
    return is_left || is_top ? samples.least_of_top_left : samples.least_of_others;
}

template <class Visit>
void for_each_covered(const TileWork& work, Visit visit) {
    const int steps = 1 << work.samples.subpixel_bits;
    for (std::uint32_t i = 0; i < work.count; ++i) {
        const auto [v, id] = at(work.triangles, work.entries[i]);
        const auto area = double(edge(v[0]->p, v[1]->p, v[2]->p));
        const auto [left, right] = std::minmax({v[0]->p.x, v[1]->p.x, v[2]->p.x});
        const auto [top, bottom] = std::minmax({v[0]->p.y, v[1]->p.y, v[2]->p.y});
        for (int y = 0; y < tile_size; ++y) {
            const int sample_y = (work.samples.y0 + y) * steps + work.samples.sample_offset;
            if (sample_y < top || sample_y > bottom) continue;
            for (int x = 0; x < tile_size; ++x) {
                const int sample_x = (work.samples.x0 + x) * steps + work.samples.sample_offset;
                if (sample_x < left || sample_x > right) continue;
                const SnappedPoint p{sample_x, sample_y};
                double term[3];
                bool is_covered = true;
                for (int k = 0; k < 3; ++k) {
                    const SnappedPoint from = v[(k + 1) % 3]->p, to = v[(k + 2) % 3]->p;
                    const std::int64_t e = edge(from, to, p);
                    is_covered = is_covered && e >= least(from, to, work.samples);
                    term[k] = double(e) * (v[k]->inverse_depth / area);
                }
                if (is_covered) visit(place_in_tile(x, y), id, float((term[0] + term[1]) + term[2]));
            }
        }
    }
}

void draw(const TileWork& work) noexcept {
    for_each_covered(work, [&](int place, std::uint32_t id, float inverse_depth) {
        if (!(inverse_depth > work.pixels.inverse_depth[place])) return;
        work.pixels.inverse_depth[place] = inverse_depth;
        work.pixels.primitive[place] = id;
    });
}

void count(const TileWork& work) noexcept {
    for_each_covered(work, [&](int place, std::uint32_t, float) { ++work.pixels.primitive[place]; });
}

void clear(TilePixels& pixels, std::uint32_t primitive) noexcept {
    std::ranges::fill(pixels.inverse_depth, nothing_seen);
    std::ranges::fill(pixels.primitive, primitive);
}

void publish() noexcept {}

constexpr Kernel kernel{Isa::scalar, "plain", project, place, clear, resolve, publish, draw, count};

}  // namespace plain

/// Any kernel, on 1 to 3 threads.
void expect_plain_bits(const Scene& scene, const View& view, const Rules& rules = correct_rules) {
    const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 3);
    Pipeline in_scene_order(rules, plain::kernel, {.order = DrawOrder::as_stored});
    const Frame& expected = in_scene_order.render(scene, view);
    const Plane<std::uint32_t> fragments = Pipeline(rules, plain::kernel).count_fragments(scene, view);
    for (const Kernel& kernel : available_of(kernels)) {
        SCOPED_TRACE(kernel.name);
        Pipeline pipeline(rules, kernel);
        for (const int threads : {1, 2, 3}) {
            tbb::task_arena arena(threads);
            arena.execute([&] {
                EXPECT_TRUE(same_bits(expected, pipeline.render(scene, view))) << threads << " threads";
            });
        }
        Pipeline front_to_back(rules, kernel, {.order = DrawOrder::front_to_back});
        EXPECT_TRUE(same_bits(expected, front_to_back.render(scene, view))) << "the nearest first";
        Pipeline every_block(rules, kernel, {.hierarchical_z = HierarchicalZ::none});
        EXPECT_TRUE(same_bits(expected, every_block.render(scene, view))) << "without hierarchical z";
        EXPECT_TRUE(std::ranges::equal(fragments.pixels(), pipeline.count_fragments(scene, view).pixels()));
    }
}

enum class Kind { small, any_size, wild, behind_and_ahead };

float component(std::mt19937& random, Kind kind, double size) {
    const auto ordinary = float(uniform(random, -1, 1) * size);
    if (kind != Kind::wild) return ordinary;
    switch (random() % 60) {
        case 0:
            return std::ldexp(ordinary, int(random() % 200) - 100);
        case 1:
            return random() % 8 ? 0 : std::numeric_limits<float>::quiet_NaN();
        case 2:
            return random() % 8 ? ordinary : std::numeric_limits<float>::infinity();
        default:
            return ordinary;
    }
}

double size_of(std::mt19937& random, Kind kind) {
    if (kind == Kind::small) return 0.05;
    if (kind == Kind::behind_and_ahead) return 1;
    return std::exp(uniform(random, kind == Kind::wild ? -20 : -8, kind == Kind::wild ? 12 : 1));
}

/// In front of the eye at the origin, or all around it. Some triangles repeat a vertex, or lie in a line.
Scene crowd(std::uint32_t seed, std::size_t count, Kind kind) {
    std::mt19937 random(seed);
    std::vector<Triangle> triangles(count);
    for (Triangle& triangle : triangles) {
        const double size = size_of(random, kind);
        const double depth = uniform(random, kind == Kind::behind_and_ahead ? -2 : 0.2, 12);
        const glm::vec3 middle{float(uniform(random, -6, 6)), float(uniform(random, -4, 4)), float(-depth)};
        for (glm::vec3& p : triangle)
            for (int k = 0; k < 3; ++k) p[k] = middle[k] + component(random, kind, size);
        if (random() % 50 == 0) triangle[2] = triangle[1];
        if (random() % 50 == 0) triangle[2] = 0.5f * (triangle[0] + triangle[1]);
    }
    return scene_of(triangles);
}

TEST(EveryIsa, DrawsTheSuiteLikeThePlainScan) {
    for (const SuiteEntry& entry : suite_manifest()) {
        if (entry.name == "million_triangles") continue;  // one size of triangle: crowds of small ones do it
        SCOPED_TRACE(entry.name);
        const Loaded loaded = generate_suite_scene(entry.name, 96, 54);
        for (View view : loaded.views) {
            view.width = 96;
            view.height = 54;
            expect_plain_bits(loaded.scene, view);
        }
    }
}

TEST(EveryIsa, DrawsAQuarterMillionTrianglesOfEachKindLikeThePlainScan) {
    for (const Kind kind : {Kind::small, Kind::any_size, Kind::wild, Kind::behind_and_ahead}) {
        for (std::uint32_t seed = 0; seed < 5; ++seed) {
            SCOPED_TRACE(std::to_string(int(kind)) + ", seed " + std::to_string(seed));
            const Scene scene = crowd(seed, 50'000, kind);
            expect_plain_bits(scene, {.name = "perspective", .camera = {}, .width = 75, .height = 67});
        }
    }
}

TEST(EveryIsa, DrawsParallelViewsLikeThePlainScan) {
    View view{.name = "parallel", .camera = {}, .width = 75, .height = 67};
    view.camera.projection = Projection::parallel;
    view.camera.window = {.left = -6, .right = 6, .bottom = -4, .top = 4};
    view.camera.near_depth = -3;
    view.camera.far_depth = 9;
    for (const Kind kind : {Kind::any_size, Kind::wild}) expect_plain_bits(crowd(7, 20'000, kind), view);
}

TEST(EveryIsa, DrawsByOtherRulesLikeThePlainScan) {
    const View view{.name = "rules", .camera = {}, .width = 75, .height = 67};
    const Scene scene = crowd(8, 5000, Kind::any_size);
    for (const FillRule fill : {FillRule::exclusive, FillRule::inclusive})
        expect_plain_bits(scene, view, {.fill = fill});
    expect_plain_bits(scene, view, {.subpixel_bits = 12});
    expect_plain_bits(scene, view, {.subpixel_bits = 4, .sample_offset_px = 0});
    expect_plain_bits(scene, view, {.depth_test = DepthTest::farther_wins});
}

// What early rejection allows for rounding must let the least possible step through.
TEST(EveryIsa, DrawsLayersThatComeNearerByAnUlpLikeThePlainScan) {
    std::vector<Triangle> layers;
    float depth = 3;
    for (int layer = 0; layer < 5; ++layer, depth = std::nextafter(depth, 0.0f)) {
        layers.push_back({glm::vec3{-9, -9, -depth}, glm::vec3{20, -9, -depth}, glm::vec3{-9, 20, -depth}});
        layers.push_back({glm::vec3{9, 9, -depth}, glm::vec3{-20, 9, -depth}, glm::vec3{9, -20, -depth}});
    }
    expect_plain_bits(scene_of(layers), {.name = "layers", .camera = {}, .width = 75, .height = 67});
}

/// Of the plane depth = 1 + x / 64 + y / 128. Legs of powers of two keep every pixel's depth exact.
Triangle on_plane(float x, float y, float leg) {
    Triangle triangle = at_pixels(x, y, x + leg, y, x, y + leg);
    for (glm::vec3& p : triangle) p.z = -(1 + p.x / 64 - p.y / 128);
    return triangle;
}

// Of equal depths the first of the scene wins, though the nearest are drawn first.
TEST(EveryIsa, DrawsTrianglesOfOnePlaneLikeThePlainScan) {
    for (const float leg : {4.0f, 32.0f}) {
        std::mt19937 random(9);
        std::vector<Triangle> triangles(5000);
        for (Triangle& t : triangles) t = on_plane(float(random() % 128), float(random() % 64), leg);
        expect_plain_bits(scene_of(triangles), raster_view(128, 64));
    }
}

// The farthest pixel of a tile is as near as all that is left: the first of the scene still wins there.
TEST(EveryIsa, DrawsWhatTiesWithTheFarthestPixelOfATileLikeThePlainScan) {
    std::vector<Triangle> triangles{at_pixels(0, 0, 256, 0, 0, 256), on_plane(0, 0, 256)};
    for (glm::vec3& p : triangles[0]) p.z = -(1 + 63.5f / 64 + 63.5f / 128);
    for (int i = 0; i < 3 * batch_size - 1; ++i) triangles.push_back(on_plane(float(i), 0, 2));
    expect_plain_bits(scene_of(triangles), raster_view(64, 64));
    const Frame frame = render_by(correct_rules, scene_of(triangles), raster_view(64, 64), plain::kernel);
    EXPECT_EQ(frame.primitive.at(63, 63), PrimitiveId{0});
    EXPECT_EQ(frame.primitive.at(62, 63), PrimitiveId{1});
}

// The first sample of the second tile is where a lower edge begins: an edge value of 0 is no -0, however it
// was computed: the sign would show in the depth.
TEST(EveryIsa, KeepsTheSignOfADepthOfZeroLikeThePlainScan) {
    Triangle triangle = at_pixels(64.5f, 0.5f, 10.5f, 0.5f, 40.5f, -40.5f);
    for (glm::vec3& p : triangle) p.z = 0;
    View view = raster_view(128, 64);
    view.camera.near_depth = -1;
    expect_plain_bits(scene_of({triangle}), view, {.fill = FillRule::inclusive});
}

}  // namespace
}  // namespace zproof::rasterizer
