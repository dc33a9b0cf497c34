/// The readers of OBJ and PLY, and what readers of model files share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scenes/loaded.h"
#include "scenes/scene.h"

namespace zproof {

/// The float32 nearest to a decimal number; none for text that is none, and for numbers beyond float32.
std::optional<float> finite_float(std::string_view text);

/// The normal at length 1; 0 where it has no direction or is not finite.
glm::vec3 unit_normal(const glm::dvec3& normal);

/// uv as glTF has it, v down, of uv whose v is up.
glm::vec2 uv_of_v_up(float u, float v);

/// Throws SceneError beyond the limit of triangles.
void check_triangles(const std::filesystem::path& file, std::string_view place, std::uint64_t count);

/// Triangles in a row.
struct TriangleRun {
    std::uint32_t first = 0, count = 0;
};

/// Appends triangles (0, i, i + 1) of a polygon's corners. Throws SceneError beyond the limit of triangles.
TriangleRun append_fan(const std::filesystem::path& file, std::string_view place,
                       std::span<const std::uint32_t> corners, Scene& scene);

/// The corners of triangle i of a strip: odd ones have their last two swapped, so that all wind alike.
constexpr glm::uvec3 corners_in_strip(std::uint32_t i) { return {i, i + 1 + i % 2, i + 2 - i % 2}; }

/// Notes triangles without area, and that there are none.
void note_triangles(Scene& scene);

/// "TEXT: COUNT", and what else is to say, for a count above 0.
void note_count(Scene& scene, std::uint64_t count, const std::string& text, const std::string& more = "");

/// A texture whose uv set no primitive has is dropped, with a note: afterwards uv_set < uv.size() for every
/// texture.
void drop_textures_without_uv(Scene& scene);

/// The scene with the view "frame-all". Throws SceneError where float32 cannot hold such an eye.
Loaded with_default_view(const std::filesystem::path& file, Scene scene, int width, int height);

/// Faces in file order; docs/scenes.md has the rest. Throws SceneError, naming the line.
Scene load_obj_scene(const std::filesystem::path& file);

/// Faces and strips in file order; docs/scenes.md has the rest. Throws SceneError, naming the line of the
/// header, the vertex, the face or the strip.
Scene load_ply_scene(const std::filesystem::path& file);

}  // namespace zproof
