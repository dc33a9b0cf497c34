#include "scenes/gltf_materials.h"

#include <cmath>

#include "scenes/refusal.h"

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

/// A number of the KHR_texture_transform object; the core schema does not know it, so it is checked here.
double number(const GltfModel& model, const tinygltf::Value& value) {
    if (!value.IsNumber() || !std::isfinite(value.GetNumberAsDouble()))
        refuse(model.file, "KHR_texture_transform", "expected a finite number");
    return value.GetNumberAsDouble();
}

glm::dvec2 pair_or(const GltfModel& model, const tinygltf::Value& of, const char* name,
                   const glm::dvec2& otherwise) {
    if (!of.Has(name)) return otherwise;
    const tinygltf::Value& pair = of.Get(name);
    if (pair.ArrayLen() != 2)
        refuse(model.file, std::string("KHR_texture_transform/") + name, "expected an array of 2 numbers");
    return {number(model, pair.Get(0)), number(model, pair.Get(1))};
}

/// translation * rotation * scale as KHR_texture_transform defines them; rotation runs counter-clockwise in
/// uv with v down: (u, v) -> (u cos + v sin, -u sin + v cos).
UvTransform uv_transform(const GltfModel& model, const tinygltf::Value& extension) {
    const glm::dvec2 scale = pair_or(model, extension, "scale", glm::dvec2(1));
    const double angle = extension.Has("rotation") ? number(model, extension.Get("rotation")) : 0;
    const double c = std::cos(angle), s = std::sin(angle);
    return {glm::dmat2(c * scale.x, -s * scale.x, s * scale.y, c * scale.y),
            pair_or(model, extension, "offset", glm::dvec2(0))};
}

void apply_transform(const GltfModel& model, const tinygltf::TextureInfo& use, Texture& texture) {
    const auto found = use.extensions.find("KHR_texture_transform");
    if (found == use.extensions.end()) return;
    if (!found->second.IsObject()) refuse(model.file, "KHR_texture_transform", "expected an object");
    texture.transform = uv_transform(model, found->second);
    if (!found->second.Has("texCoord")) return;
    const double uv_set = number(model, found->second.Get("texCoord"));
    if (!(uv_set >= 0 && uv_set < 1000))
        refuse(model.file, "KHR_texture_transform/texCoord", "expected a uv set");
    texture.uv_set = static_cast<int>(uv_set);
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
    apply_transform(model, use, texture);
    return texture;
}

glm::vec4 factor_of(const std::vector<double>& factor) {
    glm::vec4 color(1.0f);
    for (std::size_t c = 0; c < factor.size() && c < 4; ++c)
        color[static_cast<int>(c)] = static_cast<float>(factor[c]);
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
        scene.materials.push_back(
            {material.name, factor_of(material.pbrMetallicRoughness.baseColorFactor), texture});
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
