/// The baked scene: the one input of every renderer.
///
/// Positions are world space, float32, rounded once; from here on they are exact numbers. Triangles stand in
/// file order (glTF: depth-first node order, primitives in order, triangles in order); their index is the
/// primitive id.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "math/bulk.h"
#include "scenes/padded_allocator.h"

namespace zproof {

enum class Wrap { repeat, clamp_to_edge, mirrored_repeat };
enum class Minification {
    nearest,
    linear,
    nearest_mip_nearest,
    linear_mip_nearest,
    nearest_mip_linear,
    linear_mip_linear
};
enum class Magnification { nearest, linear };

struct Sampler {
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    Minification minification = Minification::linear_mip_linear;
    Magnification magnification = Magnification::linear;
};

/// 8-bit RGBA texels as stored (colour sRGB-encoded), row 0 first; texels.size() == 4 * width * height.
struct Image {
    std::string name;
    int width = 0, height = 0;
    std::vector<std::uint8_t> texels;
    /// For a texture of floats: linear light, one RGBA a texel; `texels` are the codes nearest to it. Else
    /// empty.
    std::vector<glm::vec4> light{};
};

/// uv_texture = translation + linear * uv (KHR_texture_transform).
struct UvTransform {
    glm::dmat2 linear{1.0};
    glm::dvec2 translation{0.0};
};

struct Texture {
    static constexpr int none = -1;
    int image = none;  ///< index into Scene::images, or none
    Sampler sampler;
    int uv_set = 0;
    UvTransform transform;
};

struct Material {
    std::string name;
    glm::vec4 base_color_factor{1.0f};  ///< linear
    Texture base_color;
    glm::dvec4 base_color_factor_rounding{0.0};  ///< the file's number less base_color_factor
};

/// Readable for 16 bytes at the last vertex, so that a renderer may share it without a copy.
using Positions = std::vector<glm::vec3, PaddedAllocator<glm::vec3>>;

/// Attributes are per vertex; an empty vector means that no primitive has the attribute, otherwise its size
/// is that of positions (vertices without it hold the default: normal 0, uv 0, colour 1).
struct Vertices {
    Positions position_world;
    Bulk<glm::vec3> normal_world;
    std::vector<Bulk<glm::vec2>> uv;  ///< by uv set
    Bulk<glm::vec4> color;            ///< linear RGBA
};

/// A run of triangles that came from one primitive of one mesh at one node.
struct Part {
    std::string node, mesh;
    int primitive = 0;  ///< index within the mesh
    std::uint32_t first_triangle = 0, triangle_count = 0;
    int material = 0;    ///< index into Scene::materials
    int node_index = 0;  ///< of the glTF file; 0 in a scene that is from none
};

struct Scene {
    std::string name;
    Vertices vertices;
    Bulk<glm::uvec3> triangles;       ///< vertex indices, all in range
    std::vector<Part> parts;          ///< in triangle order, covering every triangle
    std::vector<Material> materials;  ///< at least one where there are parts
    std::vector<Image> images;
    std::vector<std::string> notes;  ///< what baking left out or chose: "KIND", or "KIND: MORE"
};

}  // namespace zproof
