#include "scenes/gltf_images.h"

#include <tbb/parallel_for.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/gltf_check.h"
#include "scenes/gltf_image.h"
#include "scenes/gltf_limits.h"
#include "scenes/gltf_schema.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;

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

/// What stands in the URI, or in the file that it names; only the former says of what type it is.
void read_uri(const std::string& uri, const Admitted& admitted, Encoded& image) {
    if (tinygltf::IsDataURI(uri)) {
        std::vector<unsigned char> bytes;
        tinygltf::DecodeDataURI(&bytes, image.declared_type, uri, 0, false);
        image.own.assign(bytes.begin(), bytes.end());
    } else {
        image.own = admitted.read(uri);
    }
    image.bytes = image.own;
}

void read_view(const json& declared, const GltfModel& model, Encoded& image) {
    const tinygltf::BufferView& view = model.gltf.bufferViews[declared["bufferView"].get<std::size_t>()];
    image.declared_type = declared.value("mimeType", std::string());
    image.bytes =
        model.buffers[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
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
std::vector<Encoded> encoded_images(const json& gltf, const Admitted& admitted, GltfModel& model) {
    std::vector<Encoded> images;
    std::uint64_t texels = 0;
    for (const int index : images_in_use(gltf)) {
        const json& declared = gltf["images"][static_cast<std::size_t>(index)];
        Encoded& image = images.emplace_back();
        image.index = index;
        image.name = declared.value("name", std::string());
        const auto uri = declared.find("uri");
        uri == declared.end() ? read_view(declared, model, image) : read_uri(*uri, admitted, image);
        image.refusal = fault_of(image, texels);
        if (!image.refusal.empty()) break;
        note_type(image, model);
    }
    return images;
}

}  // namespace

void read_images(const json& gltf, const Admitted& admitted, GltfModel& model) {
    std::vector<Encoded> images = encoded_images(gltf, admitted, model);
    tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) { decode(images[i]); });
    for (Encoded& image : images) {
        if (!image.refusal.empty()) refuse(model.file, image_place(image.index), image.refusal);
        model.images.emplace(image.index, std::move(image.decoded));
    }
    if (const std::size_t unread = list_of(gltf, "images").size() - images.size(); unread > 0)
        model.notes.push_back("images not read, since no base colour texture uses them: " +
                              std::to_string(unread));
}

}  // namespace zproof
