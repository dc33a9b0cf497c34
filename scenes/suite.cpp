#include "scenes/suite.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "frame/number_text.h"
#include "scenes/scene_error.h"
#include "scenes/suite/manifest.h"
#include "scenes/suite/scenes.h"

namespace zproof {

namespace {

struct SuiteGenerator {
    std::string_view name;
    Loaded (*build)(suite::ImageSize size);
};

constexpr std::array suite_generators{
    SuiteGenerator{"near_plane", suite::near_plane},
    SuiteGenerator{"clip_blades", suite::clip_blades},
    SuiteGenerator{"guard_band", suite::guard_band},
    SuiteGenerator{"million_triangles", suite::million_triangles},
    SuiteGenerator{"deep_overdraw", suite::deep_overdraw},
    SuiteGenerator{"slivers", suite::slivers},
    SuiteGenerator{"degenerate", suite::degenerate},
    SuiteGenerator{"fan_at_pixel_centre", suite::fan_at_pixel_centre},
    SuiteGenerator{"shared_edges", suite::shared_edges},
    SuiteGenerator{"beside_pixel_centres", suite::beside_pixel_centres},
    SuiteGenerator{"coplanar", suite::coplanar},
    SuiteGenerator{"interpenetrating", suite::interpenetrating},
    SuiteGenerator{"t_junctions", suite::t_junctions},
    SuiteGenerator{"abutting_strips", suite::abutting_strips},
    SuiteGenerator{"far_from_origin", suite::far_from_origin},
    SuiteGenerator{"depth_range", suite::depth_range},
    SuiteGenerator{"back_faces", suite::back_faces},
    SuiteGenerator{"closed_surfaces", suite::closed_surfaces},
    SuiteGenerator{"off_axis", suite::off_axis},
    SuiteGenerator{"orthographic", suite::orthographic},
    SuiteGenerator{"oblique", suite::oblique},
    SuiteGenerator{"textured_ground", suite::textured_ground},
    SuiteGenerator{"room", suite::room},
    SuiteGenerator{"odd_cameras", suite::odd_cameras},
    SuiteGenerator{"picture_sizes", suite::picture_sizes},
    SuiteGenerator{"far_at_infinity", suite::far_at_infinity},
    SuiteGenerator{"parallel_planes", suite::parallel_planes},
    SuiteGenerator{"frustum_cuts", suite::frustum_cuts},
    SuiteGenerator{"clipped_tips", suite::clipped_tips},
    SuiteGenerator{"high_ids", suite::high_ids},
    SuiteGenerator{"ids_beyond_float", suite::ids_beyond_float},
    SuiteGenerator{"far_indices", suite::far_indices},
    SuiteGenerator{"many_primitives", suite::many_primitives},
    SuiteGenerator{"one_box", suite::one_box},
    SuiteGenerator{"one_tile", suite::one_tile},
    SuiteGenerator{"pile_of_a_million", suite::pile_of_a_million},
};

SuiteEntry entry_of(const nlohmann::json& scene) {
    SuiteEntry entry{.name = scene.at("name"),
                     .reason = scene.at("reason"),
                     .expects = scene.at("expects").get<std::vector<std::string>>(),
                     .size = {}};
    if (!scene.contains("size")) return entry;
    const nlohmann::json& size = scene.at("size");
    entry.has_own_sizes = size == "own";
    if (!entry.has_own_sizes) entry.size = {size.at(0), size.at(1)};
    return entry;
}

std::vector<SuiteEntry> entries_of(const char* list) {
    const nlohmann::json manifest = nlohmann::json::parse(suite::manifest_json());
    std::vector<SuiteEntry> entries;
    for (const nlohmann::json& scene : manifest.at(list)) entries.push_back(entry_of(scene));
    return entries;
}

}  // namespace

std::vector<SuiteEntry> suite_manifest() { return entries_of("scenes"); }

std::vector<SuiteEntry> thorough_manifest() { return entries_of("thorough_scenes"); }

Loaded generate_suite_scene(const std::string& name, int width, int height) {
    if (width < 1 || height < 1)
        throw SceneError("suite scene '" + name + "': the image is " + size_text(width, height) +
                         " pixels, expected at least 1 x 1");
    const auto generator = std::ranges::find(suite_generators, name, &SuiteGenerator::name);
    if (generator == suite_generators.end())
        throw SceneError("the suite has no scene '" + name +
                         "'; its manifest, scenes/suite/manifest.json, lists all");
    return generator->build({.width = width, .height = height});
}

}  // namespace zproof
