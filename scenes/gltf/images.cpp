#include "scenes/gltf/images.h"

#include <tbb/parallel_for.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/limits.h"
#include "scenes/refusal.h"
#include "scenes/texture_image.h"

namespace zproof {
namespace {

std::string image_place(int index) { return "/images/" + std::to_string(index); }

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
std::set<int> images_in_use(const tinygltf::Model& gltf) {
    std::set<int> images;
    for (const tinygltf::Material& material : gltf.materials) {
        const int texture = material.pbrMetallicRoughness.baseColorTexture.index;
        const int source = texture < 0 ? -1 : gltf.textures[static_cast<std::size_t>(texture)].source;
        if (source >= 0) images.insert(source);
    }
    return images;
}

/// The bytes stand in a buffer, in a file, or in a data URI, which tinygltf has decoded.
void read_bytes(const tinygltf::Image& declared, Admission& admission, const GltfModel& model,
                Encoded& image) {
    image.declared_type = declared.mimeType;
    image.bytes = declared.image;
    if (declared.bufferView >= 0) {
        const auto& view = model.gltf.bufferViews[static_cast<std::size_t>(declared.bufferView)];
        const auto& buffer = model.gltf.buffers[static_cast<std::size_t>(view.buffer)];
        image.bytes = std::span(buffer.data).subspan(view.byteOffset, view.byteLength);
    } else if (!declared.uri.empty()) {
        const AdmittedFile file = admission.admit(image_place(image.index) + "/uri", declared.uri);
        image.own.resize(file.bytes);
        read_first(file.path, image.own);
        image.bytes = image.own;
    }
}

void note_type(const Encoded& image, GltfModel& model) {
    const bool is_png = image_extent(image.bytes).format == ImageExtent::Format::png;
    const std::string found = is_png ? "image/png" : "image/jpeg";
    if (!image.declared_type.empty() && image.declared_type != found)
        model.notes.push_back(
            on_one_line(image_place(image.index) + ": declared " + image.declared_type + ", is " + found));
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
    for (const int index : images_in_use(model.gltf)) {
        const tinygltf::Image& declared = model.gltf.images[static_cast<std::size_t>(index)];
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
        if (!image.refusal.empty()) refuse(model.file, image_place(image.index), image.refusal);
        model.images.emplace(image.index, std::move(image.decoded));
    }
    if (const std::size_t unread = model.gltf.images.size() - images.size(); unread > 0)
        model.notes.push_back("images not read, since no base colour texture uses them: " +
                              std::to_string(unread));
}

}  // namespace zproof
