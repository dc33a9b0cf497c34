#include "scenes/polygon_mesh.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "scenes/flat_triangles.h"
#include "scenes/frame_all.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

/// The number that the whole text is.
template <typename T>
std::optional<T> number_in(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

}  // namespace

std::optional<float> finite_float(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    if (const auto value = number_in<float>(text)) return value;
    const auto value = number_in<double>(text);  // too small for float32, or no number, or too large
    return value && std::abs(*value) < 1 ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

glm::vec3 unit_normal(const glm::dvec3& normal) {
    const double length = glm::length(normal);
    return length > 0 && std::isfinite(length) ? glm::vec3(normal / length) : glm::vec3(0);
}

glm::vec2 uv_of_v_up(float u, float v) { return {u, static_cast<float>(1.0 - double{v})}; }

void check_triangles(const std::filesystem::path& file, std::string_view place, std::uint64_t count) {
    if (count > limits::triangles)
        refuse(file, place, "more than " + std::to_string(limits::triangles) + " triangles; split the scene");
}

TriangleRun append_fan(const std::filesystem::path& file, std::string_view place,
                       std::span<const std::uint32_t> corners, Scene& scene) {
    const std::size_t first = scene.triangles.size();
    check_triangles(file, place, first + corners.size());
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        scene.triangles.emplace_back(corners[0], corners[i], corners[i + 1]);
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(scene.triangles.size() - first)};
}

void note_count(Scene& scene, std::uint64_t count, const std::string& text, const std::string& more) {
    if (count > 0) scene.notes.push_back(text + ": " + std::to_string(count) + more);
}

void note_triangles(Scene& scene) {
    note_count(scene, flat_among(scene.triangles, scene.vertices.position_world),
               "triangles without area, kept");
    if (scene.triangles.empty()) scene.notes.push_back("no triangles: there is nothing to judge");
}

void drop_textures_without_uv(Scene& scene) {
    std::uint64_t dropped = 0;
    for (Material& material : scene.materials) {
        Texture& texture = material.base_color;
        const bool has_uv = static_cast<std::size_t>(texture.uv_set) < scene.vertices.uv.size() &&
                            !scene.vertices.uv[static_cast<std::size_t>(texture.uv_set)].empty();
        if (has_uv) continue;
        dropped += texture.image != Texture::none;
        texture = {};
    }
    note_count(scene, dropped, "materials untextured, since no primitive has their uv set");
}

Loaded with_default_view(const std::filesystem::path& file, Scene scene, int width, int height) {
    try {
        const Camera camera = frame_all(scene, static_cast<double>(width) / height);
        return {std::move(scene), {{"frame-all", camera, width, height}}};
    } catch (const SceneError& error) {
        refuse(file, "cameras", error.what());
    }
}

}  // namespace zproof
