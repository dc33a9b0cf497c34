#include "scenes/suite.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scenes/scene_error.h"
#include "scenes/suite/manifest.h"
#include "scenes/suite/scenes.h"

namespace zproof {

namespace {

struct Generator {
    std::string_view name;
    Loaded (*build)(suite::ImageSize size);
};

constexpr std::array generators{
    Generator{"near_plane", suite::near_plane},
    Generator{"clip_blades", suite::clip_blades},
    Generator{"guard_band", suite::guard_band},
    Generator{"million_triangles", suite::million_triangles},
    Generator{"deep_overdraw", suite::deep_overdraw},
    Generator{"slivers", suite::slivers},
    Generator{"degenerate", suite::degenerate},
    Generator{"fan_at_pixel_centre", suite::fan_at_pixel_centre},
    Generator{"shared_edges", suite::shared_edges},
    Generator{"coplanar", suite::coplanar},
    Generator{"interpenetrating", suite::interpenetrating},
    Generator{"t_junctions", suite::t_junctions},
    Generator{"abutting_strips", suite::abutting_strips},
    Generator{"far_from_origin", suite::far_from_origin},
    Generator{"depth_range", suite::depth_range},
    Generator{"back_faces", suite::back_faces},
    Generator{"closed_surfaces", suite::closed_surfaces},
    Generator{"off_axis", suite::off_axis},
    Generator{"orthographic", suite::orthographic},
    Generator{"oblique", suite::oblique},
    Generator{"textured_ground", suite::textured_ground},
    Generator{"room", suite::room},
};

}  // namespace

std::vector<SuiteEntry> suite_manifest() {
    const nlohmann::json manifest = nlohmann::json::parse(suite::manifest_json());
    std::vector<SuiteEntry> entries;
    for (const nlohmann::json& scene : manifest.at("scenes"))
        entries.push_back({.name = scene.at("name"),
                           .reason = scene.at("reason"),
                           .expects = scene.at("expects").get<std::vector<std::string>>()});
    return entries;
}

Loaded generate_suite_scene(const std::string& name, int width, int height) {
    if (width < 1 || height < 1)
        throw SceneError("suite scene '" + name + "': the image is " + std::to_string(width) + " x " +
                         std::to_string(height) + " pixels, expected at least 1 x 1");
    const auto generator = std::ranges::find(generators, name, &Generator::name);
    if (generator == generators.end())
        throw SceneError("the suite has no scene '" + name +
                         "'; its manifest, scenes/suite/manifest.json, lists all");
    return generator->build({.width = width, .height = height});
}

}  // namespace zproof
