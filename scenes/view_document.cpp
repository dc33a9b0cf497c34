#include "scenes/view_document.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scenes/camera_matrices.h"
#include "scenes/scene_error.h"

namespace zproof {

namespace {

using nlohmann::json;

/// nlohmann::json writes every double with as many digits as it takes to read the same double back.
json coordinates(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

std::string name_of(NdcDepth depth) {
    switch (depth) {
        case NdcDepth::minus_one_to_one:
            return "minus_one_to_one";
        case NdcDepth::zero_to_one:
            return "zero_to_one";
        case NdcDepth::zero_to_one_reversed:
            break;
    }
    return "zero_to_one_reversed";
}

json view_entry(const View& view) {
    const Camera& camera = view.camera;
    const Window& window = camera.window;
    json entry = {{"name", view.name},
                  {"width", view.width},
                  {"height", view.height},
                  {"eye", coordinates(glm::dvec3(camera.eye_world))},
                  {"right", coordinates(camera.right)},
                  {"up", coordinates(camera.up)},
                  {"back", coordinates(camera.back)},
                  {"near", camera.near_depth},
                  {"ndc_depth", name_of(camera.ndc_depth)}};
    entry["exact_window"] = {
        {"left", window.left}, {"right", window.right}, {"bottom", window.bottom}, {"top", window.top}};
    if (std::isinf(camera.far_depth))
        entry["far"] = "infinity";
    else
        entry["far"] = camera.far_depth;
    entry["projection"] = camera.projection == Projection::perspective ? "perspective" : "parallel";
    if (camera.projection == Projection::parallel) entry["shear"] = {camera.shear.x, camera.shear.y};
    return entry;
}

/// x_raster and y_raster of (x_ndc, y_ndc, z_ndc, 1): y runs down, the origin is the upper left corner.
std::array<std::array<double, 4>, 2> raster_from_ndc(const View& view) {
    return {std::array{view.width / 2.0, 0.0, 0.0, view.width / 2.0},
            std::array{0.0, -view.height / 2.0, 0.0, view.height / 2.0}};
}

bool is_name_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
}

}  // namespace

std::string view_name(const std::string& text) {
    std::string name = text.substr(0, 64);
    for (char& c : name)
        if (!is_name_character(c)) c = '_';
    if (name.empty()) return "camera";
    if (name.front() == '.') name.front() = '_';
    return name;
}

std::string camera_document(const View& view) {
    json entry = view_entry(view);
    entry["camera_from_world"] = camera_from_world(view.camera);
    entry["clip_from_camera"] = clip_from_camera(view.camera);
    entry["raster_from_ndc"] = raster_from_ndc(view);
    entry["sample_px"] = {view.sample.offset_px.x, view.sample.offset_px.y};
    return entry.dump(2) + "\n";
}

std::string view_document(const std::string& scene, std::span<const View> views) {
    json document = {{"scene", scene}, {"views", json::array()}};
    for (const View& view : views) document["views"].push_back(view_entry(view));
    try {
        return document.dump(2) + "\n";
    } catch (const json::type_error&) {
        throw SceneError(scene +
                         ": a path that is no UTF-8, which a view file cannot name; rename the model");
    }
}

}  // namespace zproof
