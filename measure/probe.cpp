#include "measure/probe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace zproof::measure {
namespace {

/// The place of a finite float32 among all of them, in order; both zeros have one place.
std::int64_t place_of(float value) {
    const std::int64_t magnitude = std::bit_cast<std::uint32_t>(value) & 0x7FFF'FFFFu;
    return std::signbit(value) ? -magnitude : magnitude;
}

float at_place(std::int64_t place) {
    const float magnitude = std::bit_cast<float>(std::uint32_t(place < 0 ? -place : place));
    return place < 0 ? -magnitude : magnitude;
}

/// One picture of all probes, each at its own place.
std::vector<char> answers(const Renderer& renderer, const View& view, const std::vector<Probe>& probes,
                          const std::vector<std::int64_t>& places) {
    Scene scene;
    for (std::size_t i = 0; i < probes.size(); ++i) probes[i].draw(scene, at_place(places[i]));
    const Frame frame = renderer.render(scene, view);
    std::vector<char> all;
    for (const Probe& probe : probes) all.push_back(probe.answer(frame));
    return all;
}

void expect_everywhere(char expected, const std::vector<char>& answers) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (answers[i] != expected)
            throw Unmeasurable{"probe " + std::to_string(i) + " is answered '" + (expected ? "no" : "yes") +
                               "' at the end where every renderer must say '" + (expected ? "yes" : "no") +
                               "'"};
    }
}

}  // namespace

View raster_view(int width, int height) {
    View view{.name = "raster", .camera = {}, .width = width, .height = height};
    view.camera.projection = Projection::parallel;
    view.camera.window = {.left = 0, .right = double(width), .bottom = -double(height), .top = 0};
    view.camera.near_depth = 0.5;
    view.camera.far_depth = 2;
    return view;
}

void add_triangle(Scene& scene, Axis axis, const RasterTriangle& corners) {
    const auto first = std::uint32_t(scene.vertices.position_world.size());
    for (const RasterPoint& p : corners) {
        const double x = axis == Axis::x ? p.along : p.across, y = axis == Axis::x ? p.across : p.along;
        scene.vertices.position_world.push_back(glm::vec3{float(x), float(-y), -1.0f});
    }
    scene.triangles.push_back({first, first + 1, first + 2});
}

bool is_covered(const Frame& frame, Axis axis, int along, int across) {
    const PrimitiveId id =
        axis == Axis::x ? frame.primitive.at(along, across) : frame.primitive.at(across, along);
    return id != PrimitiveId::none;
}

std::vector<Flip> bisect(const Renderer& renderer, const View& view, const std::vector<Probe>& probes) {
    std::vector<std::int64_t> low, high;
    for (const Probe& probe : probes) {
        low.push_back(place_of(probe.low));
        high.push_back(place_of(probe.high));
    }
    expect_everywhere(true, answers(renderer, view, probes, low));
    expect_everywhere(false, answers(renderer, view, probes, high));
    for (bool is_open = true; is_open;) {
        is_open = false;
        std::vector<std::int64_t> middle;
        for (std::size_t i = 0; i < probes.size(); ++i) middle.push_back(low[i] + (high[i] - low[i]) / 2);
        const std::vector<char> all = answers(renderer, view, probes, middle);
        for (std::size_t i = 0; i < probes.size(); ++i) {
            if (high[i] - low[i] <= 1) continue;
            (all[i] ? low[i] : high[i]) = middle[i];
            is_open = is_open || high[i] - low[i] > 1;
        }
    }
    std::vector<Flip> flips;
    for (std::size_t i = 0; i < probes.size(); ++i) flips.push_back({at_place(low[i]), at_place(high[i])});
    return flips;
}

Flip bisect_in_lanes(const Renderer& renderer, const View& view, const std::vector<Probe>& lanes) {
    std::int64_t low = place_of(lanes.front().low), high = place_of(lanes.front().high);
    const auto count = std::int64_t(lanes.size());
    std::vector<std::int64_t> places(lanes.size());
    for (std::int64_t i = 1; i < count; ++i)
        places[std::size_t(i)] = std::max(low + 1, low + (high - low) * i / (count - 1));
    places.front() = low;
    std::vector<char> all = answers(renderer, view, lanes, places);
    expect_everywhere(true, {all.front()});
    expect_everywhere(false, {all.back()});
    for (;;) {
        const auto no = std::size_t(std::ranges::find(all, false) - all.begin());
        if (no < all.size()) high = places[no];
        // where two lanes asked at one place, others asked at the place before it
        if (no > 0) low = std::min(places[no - 1], high - 1);
        if (high - low <= 1) return {at_place(low), at_place(high)};
        for (std::int64_t i = 0; i < count; ++i)
            places[std::size_t(i)] = std::max(low + 1, low + (high - low) * (i + 1) / (count + 1));
        all = answers(renderer, view, lanes, places);
    }
}

double simplest_in(const Bracket& bracket) {
    for (double step = 1;; step /= 2) {
        const double candidate = std::ceil(bracket.low / step) * step;
        if (candidate <= bracket.high) return candidate;
    }
}

}  // namespace zproof::measure
