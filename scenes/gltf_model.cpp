#include "scenes/gltf_model.h"

#include <set>
#include <stdexcept>

#include "scenes/gltf_check.h"
#include "scenes/gltf_image.h"
#include "scenes/gltf_limits.h"
#include "scenes/gltf_schema.h"
#include "scenes/json_text.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using Path = std::filesystem::path;

/// What the callbacks of tinygltf see.
struct Reading {
    const Path& file;
    const Admitted& admitted;
    const std::set<int>& in_use;
    std::map<int, Image> images;
    std::vector<std::string> notes;
    std::uint64_t texels = 0;
    /// Which image was refused, and why; exceptions may not cross the library's frames.
    std::string refused_image, refusal;
};

bool is_admitted(const std::string& name, void* reading) {
    return static_cast<Reading*>(reading)->admitted.contains(name);
}

std::string unexpanded(const std::string& name, void*) { return name; }

bool read_admitted(std::vector<unsigned char>* bytes, std::string*, const std::string& name, void* reading) {
    *bytes = static_cast<Reading*>(reading)->admitted.read(name);
    return true;
}

bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

std::string image_place(int index) { return "/images/" + std::to_string(index); }

void note_type(Reading& reading, const tinygltf::Image& image, int index, ImageExtent::Format format) {
    const std::string found = format == ImageExtent::Format::png ? "image/png" : "image/jpeg";
    if (!image.mimeType.empty() && image.mimeType != found)
        reading.notes.push_back(
            on_one_line(image_place(index) + ": declared " + image.mimeType + ", is " + found));
}

void take_image(Reading& reading, const tinygltf::Image& image, int index,
                std::span<const unsigned char> bytes) {
    const std::string fault = image_fault(bytes);
    if (!fault.empty()) throw std::runtime_error(fault);
    const auto [format, width, height] = image_extent(bytes);
    reading.texels += width * height;
    if (reading.texels > limits::all_texels)
        throw std::runtime_error("too many texels: at most " + std::to_string(limits::all_texels) +
                                 " in all images");
    note_type(reading, image, index, format);
    Image decoded = decode_image(bytes);
    decoded.name = image.name;
    reading.images.emplace(index, std::move(decoded));
}

bool load_image(tinygltf::Image* image, const int index, std::string*, std::string*, int, int,
                const unsigned char* bytes, int size, void* state) {
    Reading& reading = *static_cast<Reading*>(state);
    if (!reading.in_use.contains(index)) return true;
    try {
        take_image(reading, *image, index, {bytes, static_cast<std::size_t>(size)});
    } catch (const std::exception& error) {
        reading.refused_image = image_place(index);
        reading.refusal = error.what();
    }
    return reading.refusal.empty();
}

/// Runs tinygltf on what was checked. It trusts indices and sizes, so nothing unchecked may reach it.
tinygltf::Model parse(Reading& reading, const Container& container, const Bytes& bytes) {
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks({is_admitted, unexpanded, read_admitted, write_nothing, &reading});
    parser.SetImageLoader(load_image, &reading);
    tinygltf::Model model;
    std::string error, warning;
    const auto size = static_cast<unsigned>(bytes.size());
    bool is_read = false;
    try {
        is_read = container.is_glb
                      ? parser.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(), size)
                      : parser.LoadASCIIFromString(&model, &error, &warning, container.json.data(), size, "");
    } catch (const std::exception& thrown) {
        error = thrown.what();
    }
    if (!reading.refusal.empty()) refuse(reading.file, reading.refused_image, reading.refusal);
    if (!is_read) refuse(reading.file, "glTF", "cannot be read: " + error);
    return model;
}

void note_unread_images(GltfModel& model, const std::set<int>& in_use) {
    const std::size_t unread = model.gltf.images.size() - in_use.size();
    if (unread > 0)
        model.notes.push_back("images not read, since no base colour texture uses them: " +
                              std::to_string(unread));
}

}  // namespace

GltfModel read_gltf(const Path& file) {
    const Bytes bytes = read_file(file, limits::file_bytes);
    const Container container = open_container(file, bytes);
    const nlohmann::json gltf = parse_json(file, container.json);
    GltfModel model{file, {}, {}, {}};
    check_schema(file, gltf);
    model.notes = check_extensions(file, gltf);
    for (std::string& note : check_nodes(file, gltf)) model.notes.push_back(std::move(note));
    check_ranges(file, gltf);
    check_cameras(file, gltf);
    const std::set<int> in_use = images_in_use(gltf);
    const Admitted admitted = admit_files(file, gltf, container);
    Reading reading{file, admitted, in_use, {}, {}, 0, {}, {}};
    model.gltf = parse(reading, container, bytes);
    model.images = std::move(reading.images);
    model.notes.insert(model.notes.end(), reading.notes.begin(), reading.notes.end());
    note_unread_images(model, in_use);
    return model;
}

}  // namespace zproof
