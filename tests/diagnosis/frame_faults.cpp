#include "tests/diagnosis/frame_faults.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace zproof {

namespace {

using Inject = std::function<Frame(const Scene&, const View&, const Frame&)>;

struct PixelPosition {
    int x, y;
};

bool is_inside(Resolution size, PixelPosition p) {
    return p.x >= 0 && p.y >= 0 && p.x < size.width && p.y < size.height;
}

/// Pixel p takes its answer from source(size, p); background where that lies outside.
Inject taken_from(const std::function<PixelPosition(Resolution, PixelPosition)>& source) {
    return [=](const Scene&, const View&, const Frame& good) {
        Frame frame(good.size());
        for (int y = 0; y < good.size().height; ++y)
            for (int x = 0; x < good.size().width; ++x) {
                const PixelPosition from = source(good.size(), {x, y});
                if (!is_inside(good.size(), from)) continue;
                frame.primitive.at(x, y) = good.primitive.at(from.x, from.y);
                frame.camera_depth.at(x, y) = good.camera_depth.at(from.x, from.y);
            }
        return frame;
    };
}

Inject moved(int dx, int dy) {
    return taken_from([=](Resolution, PixelPosition p) { return PixelPosition{p.x - dx, p.y - dy}; });
}

constexpr PixelPosition nowhere{-1, -1};

bool in_tile(PixelPosition p) { return p.x / 16 == 9 && p.y / 16 == 5; }

Inject each_id(const std::function<std::uint32_t(const Scene&, std::uint32_t)>& renamed) {
    return [=](const Scene& scene, const View&, const Frame& good) {
        Frame frame = good;
        for (PrimitiveId& id : frame.primitive.pixels())
            if (id != PrimitiveId::none) id = PrimitiveId(renamed(scene, std::uint32_t(id)));
        return frame;
    };
}

const Part& part_of(const Scene& scene, std::uint32_t id) {
    return *std::ranges::find_if(
        scene.parts, [&](const Part& part) { return id - part.first_triangle < part.triangle_count; });
}

std::uint32_t within_its_part(const Scene& scene, std::uint32_t id) {
    return id - part_of(scene, id).first_triangle;
}

std::uint32_t number_of_part(const Scene& scene, std::uint32_t id) {
    return std::uint32_t(&part_of(scene, id) - scene.parts.data());
}

/// A triangle's depth and where it is seen.
struct Seen {
    const View& view;
    int x, y;
    double depth;
};

Inject each_depth(const std::function<double(const Seen&)>& changed) {
    return [=](const Scene&, const View& view, const Frame& good) {
        Frame frame = good;
        for (int y = 0; y < good.size().height; ++y)
            for (int x = 0; x < good.size().width; ++x)
                if (good.primitive.at(x, y) != PrimitiveId::none)
                    frame.camera_depth.at(x, y) =
                        float(changed({view, x, y, double(good.camera_depth.at(x, y))}));
        return frame;
    };
}

double ray_length(const Seen& s) {
    const Window& w = s.view.camera.window;
    const double u = w.left + (w.right - w.left) * (s.x + 0.5) / s.view.width;
    const double v = w.top - (w.top - w.bottom) * (s.y + 0.5) / s.view.height;
    return s.depth * std::sqrt(1 + u * u + v * v);
}

double ndc(const Seen& s, double at_near, double at_far) {
    const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
    return at_near + (at_far - at_near) * (1 / near - 1 / s.depth) / (1 / near - 1 / far);
}

double in_fixed_point(const Seen& s, int bits) {
    const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
    const double steps = std::ldexp(1.0, bits) - 1, stored = std::nearbyint(ndc(s, 0, 1) * steps) / steps;
    return 1 / (1 / near + stored * (1 / far - 1 / near));
}

double in_half_float(const Seen& s) {
    const double step = std::ldexp(1.0, std::ilogb(s.depth) - 10);
    return std::nearbyint(s.depth / step) * step;
}

Frame with_ids_one_pixel_right(const Scene&, const View&, const Frame& good) {
    Frame frame = good;
    for (int y = 0; y < good.size().height; ++y)
        for (int x = 1; x < good.size().width; ++x)
            if (good.primitive.at(x, y) != PrimitiveId::none &&
                good.primitive.at(x - 1, y) != PrimitiveId::none)
                frame.primitive.at(x, y) = good.primitive.at(x - 1, y);
    return frame;
}

Frame with_depths_one_pixel_right(const Scene&, const View&, const Frame& good) {
    Frame frame = good;
    for (int y = 0; y < good.size().height; ++y)
        for (int x = 1; x < good.size().width; ++x)
            if (good.primitive.at(x, y) != PrimitiveId::none &&
                good.primitive.at(x - 1, y) != PrimitiveId::none)
                frame.camera_depth.at(x, y) = good.camera_depth.at(x - 1, y);
    return frame;
}

/// The two ids that most pixels bear change places.
Frame with_two_swapped(const Scene& scene, const View&, const Frame& good) {
    std::vector<std::size_t> pixels(scene.triangles.size());
    for (const PrimitiveId id : good.primitive.pixels())
        if (id != PrimitiveId::none) ++pixels[std::size_t(id)];
    const auto commonest = [&] {
        const auto most = std::ranges::max_element(pixels);
        *most = 0;
        return PrimitiveId(most - pixels.begin());
    };
    const PrimitiveId a = commonest(), b = commonest();
    Frame frame = good;
    for (PrimitiveId& id : frame.primitive.pixels()) id = id == a ? b : id == b ? a : id;
    return frame;
}

Frame with_background_at_far(const Scene&, const View& view, const Frame& good) {
    Frame frame = good;
    for (float& depth : frame.camera_depth.pixels())
        if (depth == background_depth) depth = float(view.camera.far_depth);
    return frame;
}

Frame with_background_0(const Scene&, const View&, const Frame& good) {
    Frame frame = good;
    for (PrimitiveId& id : frame.primitive.pixels())
        if (id == PrimitiveId::none) id = PrimitiveId(0);
    return frame;
}

/// A quarter each: any triangle's id, a depth up to twice too far, background, NaN.
Frame with_random_faults(const Scene& scene, const View&, const Frame& good) {
    Frame frame = good;
    std::mt19937 random(7);
    const auto below = [&](std::size_t n) { return int(random() % n); };
    for (int k = 0; k < 4000; ++k) {
        const int x = below(std::size_t(good.size().width)), y = below(std::size_t(good.size().height));
        PrimitiveId& id = frame.primitive.at(x, y);
        float& depth = frame.camera_depth.at(x, y);
        switch (k % 4) {
            case 0:
                id = PrimitiveId(below(scene.triangles.size()));
                break;
            case 1:
                depth *= 1 + float(below(1000)) / 1000;
                break;
            case 2:
                id = PrimitiveId::none;
                depth = background_depth;
                break;
            default:
                depth = std::numeric_limits<float>::quiet_NaN();
        }
    }
    return frame;
}

std::vector<FrameFault> faults_of_place() {
    const auto row = [](Resolution size, PixelPosition p) { return p.y == size.height / 2; };
    return {
        {"flipped_y", "the image is flipped in y", taken_from([](Resolution s, PixelPosition p) {
             return PixelPosition{p.x, s.height - 1 - p.y};
         })},
        {"flipped_x", "the image is flipped in x", taken_from([](Resolution s, PixelPosition p) {
             return PixelPosition{s.width - 1 - p.x, p.y};
         })},
        {"turned", "the image is turned by half a turn", taken_from([](Resolution s, PixelPosition p) {
             return PixelPosition{s.width - 1 - p.x, s.height - 1 - p.y};
         })},
        {"transposed", "the image is transposed", taken_from([](Resolution, PixelPosition p) {
             return PixelPosition{p.y, p.x};
         })},
        {"transposed_and_stretched", "the image is transposed and stretched",
         taken_from([](Resolution s, PixelPosition p) {
             return PixelPosition{p.y * s.width / s.height, p.x * s.height / s.width};
         })},
        {"shifted_right", "the image is shifted by (+1, 0) px", moved(1, 0)},
        {"shifted_left", "the image is shifted by (-1, 0) px", moved(-1, 0)},
        {"shifted_down", "the image is shifted by (0, +1) px", moved(0, 1)},
        {"shifted_up", "the image is shifted by (0, -1) px", moved(0, -1)},
        {"nothing_drawn", "nothing was drawn", taken_from([](Resolution, PixelPosition) { return nowhere; })},
        {"row_lost", "rows are missing",
         taken_from([=](Resolution s, PixelPosition p) { return row(s, p) ? nowhere : p; })},
        {"last_rows_lost", "the last rows are missing",
         taken_from([](Resolution s, PixelPosition p) { return p.y >= s.height - 14 ? nowhere : p; })},
        {"first_columns_lost", "the first columns are missing",
         taken_from([](Resolution, PixelPosition p) { return p.x < 32 ? nowhere : p; })},
        {"column_lost", "columns are missing",
         taken_from([](Resolution s, PixelPosition p) { return p.x == s.width / 2 ? nowhere : p; })},
        {"tile_lost", "tiles of 16 px are missing",
         taken_from([](Resolution, PixelPosition p) { return in_tile(p) ? nowhere : p; })},
        {"row_moved", "some rows show the pixel to the left", taken_from([=](Resolution s, PixelPosition p) {
             return row(s, p) ? PixelPosition{p.x - 1, p.y} : p;
         })},
        {"rows_doubled", "some rows show the pixel above", taken_from([](Resolution, PixelPosition p) {
             return PixelPosition{p.x, p.y & ~1};
         })},
        {"tile_of_the_neighbour", "a tile of 16 px shows the one to its left",
         taken_from([](Resolution, PixelPosition p) {
             return in_tile(p) ? PixelPosition{p.x - 16, p.y} : p;
         })},
    };
}

std::vector<FrameFault> faults_of_ids() {
    using Id = std::uint32_t;
    return {
        {"ids_too_large", "ids are too large by one", each_id([](const Scene&, Id id) { return id + 1; })},
        {"ids_too_small", "ids are too small by one",
         each_id([](const Scene&, Id id) { return id == 0 ? 0 : id - 1; })},
        {"ids_of_the_pair", "even and odd ids change places",
         each_id([](const Scene&, Id id) { return id ^ 1; })},
        {"ids_from_the_end", "ids count from the last triangle",
         each_id([](const Scene& s, Id id) { return Id(s.triangles.size()) - 1 - id; })},
        {"ids_within_the_part", "ids restart in every part", each_id(within_its_part)},
        {"ids_of_parts", "the id is the part's", each_id(number_of_part)},
        {"ids_of_12_bits", "ids keep their low 12 bits",
         each_id([](const Scene&, Id id) { return id & 0xFFF; })},
        {"ids_of_vertices", "the id is a vertex's", each_id([](const Scene& s, Id id) {
             return std::min(s.triangles[id].x, Id(s.triangles.size()) - 1);
         })},
        {"ids_apart", "ids lie one pixel right of their depths", with_ids_one_pixel_right},
        {"ids_swapped", "ids are exchanged", with_two_swapped},
        {"background_0", "background has an id", with_background_0, "textured_ground"},
    };
}

std::vector<FrameFault> faults_of_depth() {
    return {
        {"ray_length", "depth is the ray's length", each_depth(ray_length)},
        {"ndc", "depth is NDC z (-1 to 1)", each_depth([](const Seen& s) { return ndc(s, -1, 1); })},
        {"ndc_from_zero", "depth is NDC z (0 to 1)", each_depth([](const Seen& s) { return ndc(s, 0, 1); })},
        {"ndc_reversed", "depth is NDC z (1 to 0, reversed)",
         each_depth([](const Seen& s) { return ndc(s, 1, 0); })},
        {"reciprocal", "depth is 1/depth", each_depth([](const Seen& s) { return 1 / s.depth; })},
        {"from_near", "depth is counted from the near plane",
         each_depth([](const Seen& s) { return s.depth - s.view.camera.near_depth; })},
        {"scaled", "depth is scaled to 0 at near and 1 at far", each_depth([](const Seen& s) {
             const Camera& c = s.view.camera;
             return (s.depth - c.near_depth) / (c.far_depth - c.near_depth);
         })},
        {"other_units", "depth is in other units", each_depth([](const Seen& s) { return 1000 * s.depth; })},
        {"depths_apart", "depths lie one pixel right of their ids", with_depths_one_pixel_right},
        {"sixteen_bits", "depth has 16 bits, fixed point",
         each_depth([](const Seen& s) { return in_fixed_point(s, 16); })},
        {"half_float", "depth is a float of 11 bits", each_depth(in_half_float)},
        {"negated", "depth has the wrong sign", each_depth([](const Seen& s) { return -s.depth; })},
        {"some_nan", "depth is not a number", each_depth([](const Seen& s) {
             return (s.x + s.y) % 7 == 0 ? std::numeric_limits<double>::quiet_NaN() : s.depth;
         })},
        {"some_infinite", "depth is infinite", each_depth([](const Seen& s) {
             return (s.x + s.y) % 7 == 0 ? std::numeric_limits<double>::infinity() : s.depth;
         })},
        {"background_at_far", "background has a depth", with_background_at_far, "textured_ground"},
    };
}

}  // namespace

const std::vector<FrameFault>& frame_faults() {
    static const std::vector<FrameFault> all = [] {
        std::vector<FrameFault> faults{{"random_mixture", "", with_random_faults}};
        for (const auto& more : {faults_of_place(), faults_of_ids(), faults_of_depth()})
            faults.insert(faults.end(), more.begin(), more.end());
        return faults;
    }();
    return all;
}

}  // namespace zproof
