#include "scenes/gltf/bake.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/limits.h"
#include "scenes/polygon_mesh.h"
#include "scenes/refusal.h"
#include "scenes/texture_image.h"

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

Sampler sampler_of(const gltf::Sampler& gl) {
    return {wrap_of(gl.wrapS), wrap_of(gl.wrapT), minification_of(gl.minFilter),
            gl.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Magnification::nearest : Magnification::linear};
}

/// translation * rotation * scale as KHR_texture_transform defines them; rotation runs counter-clockwise in
/// uv with v down: (u, v) -> (u cos + v sin, -u sin + v cos).
UvTransform uv_transform(const gltf::TextureTransform& t) {
    const double c = std::cos(t.rotation), s = std::sin(t.rotation);
    return {glm::dmat2(c * t.scale[0], -s * t.scale[0], s * t.scale[1], c * t.scale[1]),
            {t.offset[0], t.offset[1]}};
}

void apply_transform(const gltf::TextureInfo& use, Texture& texture) {
    const auto found = use.extensions.find("KHR_texture_transform");
    if (found == use.extensions.end()) return;
    const auto transform = found->get<gltf::TextureTransform>();
    texture.transform = uv_transform(transform);
    if (transform.texCoord >= 0) texture.uv_set = transform.texCoord;
}

Texture texture_of(const GltfModel& model, const gltf::TextureInfo& use,
                   const std::map<int, int>& baked_image) {
    Texture texture;
    if (use.index < 0) return texture;
    const gltf::Texture& declared = at(model.document.textures, use.index);
    if (declared.source < 0) return texture;
    texture.image = baked_image.at(declared.source);
    if (declared.sampler >= 0) texture.sampler = sampler_of(at(model.document.samplers, declared.sampler));
    texture.uv_set = use.texCoord;
    apply_transform(use, texture);
    return texture;
}

/// An image as the file has it.
struct Encoded {
    int index = 0;
    std::string name;
    std::string declared_type;  ///< none where the file does not say
    Bytes own;                  ///< where it is not in a buffer
    std::span<const unsigned char> bytes;
    Image decoded;
    std::string refusal;  ///< why it cannot be used
};

/// The glTF indices of the images that are used; no others are read.
std::set<int> images_in_use(const gltf::Document& document) {
    std::set<int> images;
    for (const gltf::Material& material : document.materials) {
        const int texture = material.pbrMetallicRoughness.baseColorTexture.index;
        const int source = texture < 0 ? -1 : at(document.textures, texture).source;
        if (source >= 0) images.insert(source);
    }
    return images;
}

/// The bytes stand in a buffer, in a data URI or in a file.
void read_bytes(const gltf::Image& declared, Admission& admission, const GltfModel& model, Encoded& image) {
    if (declared.bufferView >= 0) {
        const gltf::BufferView& view = at(model.document.bufferViews, declared.bufferView);
        image.declared_type = declared.mimeType;
        image.bytes =
            at(model.document.buffers, view.buffer).data().subspan(view.byteOffset, view.byteLength);
        return;
    }
    if (tinygltf::IsDataURI(declared.uri)) {
        DecodedUri decoded = decoded_uri(declared.uri);
        image.declared_type = decoded.type;
        image.own = std::move(decoded.bytes);
    } else {
        const AdmittedFile file = admission.admit(pointer("images", image.index, "/uri"), declared.uri);
        image.own.resize(file.bytes);
        read_first(file.path, image.own);
    }
    image.bytes = image.own;
}

void note_type(const Encoded& image, GltfModel& model) {
    const bool is_png = image_extent(image.bytes).format == ImageExtent::Format::png;
    const std::string found = is_png ? "image/png" : "image/jpeg";
    if (!image.declared_type.empty() && image.declared_type != found)
        model.notes.push_back(on_one_line("images of another type: " + pointer("images", image.index) +
                                          ": declared " + image.declared_type + ", is " + found));
}

/// Why the image cannot be decoded as far as its header tells, or nothing. Adds to the texels of all images.
std::string fault_of(const Encoded& image, std::uint64_t& texels) {
    if (std::string fault = image_fault(image.bytes); !fault.empty()) return fault;
    const ImageExtent extent = image_extent(image.bytes);
    texels += extent.width * extent.height;
    if (texels <= limits::all_texels) return {};
    return "too many texels: at most " + std::to_string(limits::all_texels) + " in all images";
}

void decode(Encoded& image) {
    if (!image.refusal.empty()) return;
    try {
        image.decoded = decode_image(image.bytes);
        image.decoded.name = image.name;
    } catch (const std::exception& error) {
        image.refusal = error.what();
    }
}

/// The images in use, up to the first whose header is at fault.
std::vector<Encoded> encoded_images(Admission& admission, GltfModel& model) {
    std::vector<Encoded> images;
    std::uint64_t texels = 0;
    for (const int index : images_in_use(model.document)) {
        const gltf::Image& declared = at(model.document.images, index);
        Encoded& image = images.emplace_back();
        image.index = index;
        image.name = declared.name;
        read_bytes(declared, admission, model, image);
        image.refusal = fault_of(image, texels);
        if (!image.refusal.empty()) break;
        note_type(image, model);
    }
    return images;
}

}  // namespace

void read_images(Admission& admission, GltfModel& model) {
    std::vector<Encoded> images = encoded_images(admission, model);
    tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) { decode(images[i]); });
    for (Encoded& image : images) {
        if (!image.refusal.empty()) refuse(model.file, pointer("images", image.index), image.refusal);
        model.images.emplace(image.index, std::move(image.decoded));
    }
    if (const std::size_t unread = model.document.images.size() - images.size(); unread > 0)
        model.notes.push_back("images not read, since no base colour texture uses them: " +
                              std::to_string(unread));
}

void bake_materials(GltfModel& model, Scene& scene) {
    std::map<int, int> baked_image;
    for (auto& [index, image] : model.images) {
        baked_image.emplace(index, static_cast<int>(scene.images.size()));
        scene.images.push_back(std::move(image));
    }
    std::uint64_t without_source = 0;
    for (const gltf::Material& material : model.document.materials) {
        const gltf::TextureInfo& use = material.pbrMetallicRoughness.baseColorTexture;
        const Texture texture = texture_of(model, use, baked_image);
        without_source += use.index >= 0 && texture.image == Texture::none;
        const std::vector<double>& color = material.pbrMetallicRoughness.baseColorFactor;
        const glm::dvec4 factor(color[0], color[1], color[2], color[3]);
        const glm::vec4 rounded{factor};
        scene.materials.push_back({material.name, rounded, texture, factor - glm::dvec4{rounded}});
    }
    scene.materials.push_back({"default", glm::vec4(1.0f), {}});
    note_count(scene, without_source, "materials untextured, since their texture has no PNG or JPEG source");
}

}  // namespace zproof
