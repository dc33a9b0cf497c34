#include "cli/plan/expected_seconds.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>
#include <sstream>
#include <utility>

#include "cli/memory.h"
#include "frame/frame_error.h"
#include "oracle/isolated.h"
#include "program/samples.h"

namespace zproof {
namespace {

/// What one process tells the other: texts that end with a zero.
oracle::Bytes to_bytes(const PlannedScene& scene) {
    std::ostringstream out;
    out << std::hexfloat << scene.setup_s << '\0';
    for (std::size_t i = 0; i < scene.views.size(); ++i)
        out << scene.view_s[i] << '\0' << scene.views[i] << '\0';
    const std::string text = std::move(out).str();
    const auto bytes = std::as_bytes(std::span{text});
    return {bytes.begin(), bytes.end()};
}

PlannedScene from_bytes(const std::string& name, const oracle::Bytes& bytes) {
    PlannedScene scene{.scene = name, .views = {}, .shards = {}, .setup_s = 0, .view_s = {}};
    std::istringstream in{std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
    std::string seconds, view;
    std::getline(in, seconds, '\0');
    scene.setup_s = std::stod(seconds);
    while (std::getline(in, seconds, '\0') && std::getline(in, view, '\0')) {
        scene.view_s.push_back(std::stod(seconds));
        scene.views.push_back(view);
    }
    return scene;
}

/// Nothing of a scene without triangles.
oracle::Bytes read(const SceneSource& source, const RenderSettings& settings, double slowness) {
    const Loaded loaded = load(source, source.size.value_or(settings.resolution));
    if (loaded.scene.triangles.empty()) return {};
    const std::vector<View> views = at_samples(loaded.views, settings.samples);
    return to_bytes(expected_of(source.name, loaded.scene, views, slowness));
}

oracle::IsolationLimits limits() {
    constexpr std::uint64_t most_bytes = std::uint64_t{1} << 46;  // an address space is not larger
    return {.memory_bytes = std::size_t(std::min(available_memory_bytes(), most_bytes)),
            .time = std::chrono::hours{24}};
}

}  // namespace

PlannedScene unknown_scene(const SceneSource& source, const RenderSettings& settings, double slowness) {
    try {
        const oracle::Bytes bytes =
            oracle::isolated(source.name, limits(), [&] { return read(source, settings, slowness); });
        if (!bytes.empty()) return from_bytes(source.name, bytes);
    } catch (const FrameError&) {  // its shard says why
    }
    return expected_of_none(source.name, slowness);
}

}  // namespace zproof
