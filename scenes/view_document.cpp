#include "scenes/view_document.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace zproof {

namespace {

using nlohmann::json;

/// nlohmann::json writes every double with as many digits as it takes to read the same double back.
json numbers(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

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
                  {"eye", numbers(glm::dvec3(camera.eye_world))},
                  {"right", numbers(camera.right)},
                  {"up", numbers(camera.up)},
                  {"back", numbers(camera.back)},
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

}  // namespace

std::string view_document(const std::string& scene, std::span<const View> views) {
    json document = {{"scene", scene}, {"views", json::array()}};
    for (const View& view : views) document["views"].push_back(view_entry(view));
    return document.dump(2) + "\n";
}

}  // namespace zproof
