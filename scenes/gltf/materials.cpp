#include "scenes/gltf/materials.h"

#include <cmath>

namespace zproof {
namespace {

Wrap wrap_of(int gl) {
    if (gl == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp_to_edge;
    return gl == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirrored_repeat : Wrap::repeat;
}

/// glTF leaves undefined filters to the viewer: trilinear here.
Minification minification_of(int gl) {
    switch (gl) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
            return Minification::nearest;
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            return Minification::linear;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
            return Minification::nearest_mip_nearest;
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
            return Minification::linear_mip_nearest;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
            return Minification::nearest_mip_linear;
        default:
            return Minification::linear_mip_linear;
    }
}

Sampler sampler_of(const tinygltf::Sampler& gl) {
    return {wrap_of(gl.wrapS), wrap_of(gl.wrapT), minification_of(gl.minFilter),
            gl.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Magnification::nearest : Magnification::linear};
}

glm::dvec2 pair_or(const tinygltf::Value& of, const char* name, const glm::dvec2& otherwise) {
    if (!of.Has(name)) return otherwise;
    const tinygltf::Value& pair = of.Get(name);
    return {pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()};
}

/// translation * rotation * scale as KHR_texture_transform defines them; rotation runs counter-clockwise in
/// uv with v down: (u, v) -> (u cos + v sin, -u sin + v cos).
UvTransform uv_transform(const tinygltf::Value& extension) {
    const glm::dvec2 scale = pair_or(extension, "scale", glm::dvec2(1));
    const double angle = extension.Has("rotation") ? extension.Get("rotation").GetNumberAsDouble() : 0;
    const double c = std::cos(angle), s = std::sin(angle);
    return {glm::dmat2(c * scale.x, -s * scale.x, s * scale.y, c * scale.y),
            pair_or(extension, "offset", glm::dvec2(0))};
}

void apply_transform(const tinygltf::TextureInfo& use, Texture& texture) {
    const auto found = use.extensions.find("KHR_texture_transform");
    if (found == use.extensions.end()) return;
    texture.transform = uv_transform(found->second);
    if (found->second.Has("texCoord")) texture.uv_set = found->second.Get("texCoord").GetNumberAsInt();
}

Texture texture_of(const GltfModel& model, const tinygltf::TextureInfo& use,
                   const std::map<int, int>& baked_image) {
    Texture texture;
    if (use.index < 0) return texture;
    const tinygltf::Texture& declared = model.gltf.textures[static_cast<std::size_t>(use.index)];
    if (declared.source < 0) return texture;
    texture.image = baked_image.at(declared.source);
    if (declared.sampler >= 0)
        texture.sampler = sampler_of(model.gltf.samplers[static_cast<std::size_t>(declared.sampler)]);
    texture.uv_set = use.texCoord;
    apply_transform(use, texture);
    return texture;
}

glm::dvec4 factor_of(const std::vector<double>& factor) {
    glm::dvec4 color(1.0);
    for (std::size_t c = 0; c < factor.size() && c < 4; ++c) color[static_cast<int>(c)] = factor[c];
    return color;
}

}  // namespace

void bake_materials(GltfModel& model, Scene& scene) {
    std::map<int, int> baked_image;
    for (auto& [index, image] : model.images) {
        baked_image.emplace(index, static_cast<int>(scene.images.size()));
        scene.images.push_back(std::move(image));
    }
    int without_source = 0;
    for (const tinygltf::Material& material : model.gltf.materials) {
        const tinygltf::TextureInfo& use = material.pbrMetallicRoughness.baseColorTexture;
        const Texture texture = texture_of(model, use, baked_image);
        without_source += use.index >= 0 && texture.image == Texture::none;
        const glm::dvec4 factor = factor_of(material.pbrMetallicRoughness.baseColorFactor);
        const glm::vec4 rounded{factor};
        scene.materials.push_back({material.name, rounded, texture, factor - glm::dvec4{rounded}});
    }
    scene.materials.push_back({"default", glm::vec4(1.0f), {}});
    if (without_source > 0)
        scene.notes.push_back("materials untextured, since their texture has no PNG or JPEG source: " +
                              std::to_string(without_source));
}

void drop_textures_without_uv(Scene& scene) {
    int dropped = 0;
    for (Material& material : scene.materials) {
        Texture& texture = material.base_color;
        const bool has_uv = static_cast<std::size_t>(texture.uv_set) < scene.vertices.uv.size() &&
                            !scene.vertices.uv[static_cast<std::size_t>(texture.uv_set)].empty();
        if (has_uv) continue;
        dropped += texture.image != Texture::none;
        texture = {};
    }
    if (dropped > 0)
        scene.notes.push_back("materials untextured, since no primitive has their uv set: " +
                              std::to_string(dropped));
}

}  // namespace zproof
