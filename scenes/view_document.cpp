#include "scenes/view_document.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

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

using Rows = std::array<std::array<double, 4>, 4>;

Rows camera_from_world(const Camera& camera) {
    const glm::dvec3 eye{camera.eye_world};
    const auto row = [&](const glm::dvec3& axis) {
        return std::array{axis.x, axis.y, axis.z, -glm::dot(axis, eye)};
    };
    return {row(camera.right), row(camera.up), row(camera.back), std::array{0.0, 0.0, 0.0, 1.0}};
}

/// What near and far become in NDC.
struct NdcRange {
    double near_z, far_z;
};

NdcRange range_of(NdcDepth depth) {
    if (depth == NdcDepth::minus_one_to_one) return {-1, 1};
    return depth == NdcDepth::zero_to_one ? NdcRange{0, 1} : NdcRange{1, 0};
}

/// z_ndc = a + b / depth, row z of the matrix (0, 0, -a, b): near and far land on the ends of the range.
std::array<double, 4> perspective_z(const Camera& camera) {
    const auto [near_z, far_z] = range_of(camera.ndc_depth);
    const double near = camera.near_depth, far = camera.far_depth;
    if (std::isinf(far)) return {0, 0, -far_z, (near_z - far_z) * near};
    return {0, 0, -(far_z * far - near_z * near) / (far - near),
            (near_z - far_z) * near * far / (far - near)};
}

/// z_ndc = near_z + (far_z - near_z) (depth - near) / (far - near).
std::array<double, 4> parallel_z(const Camera& camera) {
    const auto [near_z, far_z] = range_of(camera.ndc_depth);
    const double slope = (far_z - near_z) / (camera.far_depth - camera.near_depth);
    return {0, 0, -slope, near_z - slope * camera.near_depth};
}

Rows clip_from_camera(const Camera& camera) {
    const Window& w = camera.window;
    const double x = 2 / (w.right - w.left), y = 2 / (w.top - w.bottom);
    const double x_centre = (w.right + w.left) / (w.right - w.left),
                 y_centre = (w.top + w.bottom) / (w.top - w.bottom);
    if (camera.projection == Projection::perspective)
        return {std::array{x, 0.0, x_centre, 0.0}, std::array{0.0, y, y_centre, 0.0}, perspective_z(camera),
                std::array{0.0, 0.0, -1.0, 0.0}};
    return {std::array{x, 0.0, x * camera.shear.x, -x_centre},
            std::array{0.0, y, y * camera.shear.y, -y_centre}, parallel_z(camera),
            std::array{0.0, 0.0, 0.0, 1.0}};
}

/// x_raster and y_raster of (x_ndc, y_ndc, z_ndc, 1): y runs down, the origin is the upper left corner.
std::array<std::array<double, 4>, 2> raster_from_ndc(const View& view) {
    return {std::array{view.width / 2.0, 0.0, 0.0, view.width / 2.0},
            std::array{0.0, -view.height / 2.0, 0.0, view.height / 2.0}};
}

}  // namespace

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
