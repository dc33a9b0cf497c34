#include "scenes/gltf/model.h"

#include <concepts>
#include <span>
#include <stdexcept>

#include "scenes/gltf/check.h"
#include "scenes/gltf/compression.h"
#include "scenes/gltf/guard.h"
#include "scenes/gltf/images.h"
#include "scenes/json_text.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using Files = std::span<const AdmittedFile>;

/// tinygltf asks for the buffers' files first, in order, and then for those of the images, which it is told
/// are not there: only images in use are read, and later. The names that it asks by are not looked at.
/// Callbacks: tinygltf::FsCallbacks, which has a size from version 2.8 on.
template <class Callbacks>
Callbacks in_order(Files& files) {
    Callbacks callbacks{};
    callbacks.FileExists = [](const std::string&, void* user) { return !static_cast<Files*>(user)->empty(); };
    callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* to, std::string*, const std::string&,
                                 void* user) {
        Files& left = *static_cast<Files*>(user);
        to->resize(left.front().bytes);
        read_first(left.front().path, *to);
        left = left.subspan(1);
        return true;
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                  void*) { return false; };
    if constexpr (requires { callbacks.GetFileSizeInBytes; })
        callbacks.GetFileSizeInBytes = [](std::size_t* bytes, std::string*, const std::string&, void* user) {
            *bytes = static_cast<Files*>(user)->front().bytes;
            return true;
        };
    callbacks.user_data = &files;
    return callbacks;
}

/// From 2.8.23 on tinygltf refuses callbacks of which one is missing, and would open files by itself.
template <class Parser>
void let_read(Parser& parser, Files& files) {
    const auto callbacks = in_order<tinygltf::FsCallbacks>(files);
    if constexpr (requires {
                      { parser.SetFsCallbacks(callbacks) } -> std::same_as<bool>;
                  }) {
        if (!parser.SetFsCallbacks(callbacks)) throw std::logic_error{"tinygltf wants another callback"};
    } else {
        parser.SetFsCallbacks(callbacks);
    }
}

/// Keeps what a data URI holds; decodes nothing.
bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    return true;
}

/// A GLB without bytes in a BIN chunk is given as text, since tinygltf refuses an empty or unknown second
/// chunk.
tinygltf::Model parsed(const std::filesystem::path& file, const Bytes& bytes, const Container& container,
                       Files files) {
    tinygltf::TinyGLTF parser;
    let_read(parser, files);
    parser.SetImageLoader(keep_encoded, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    const bool is_read = container.bin.empty()
                             ? parser.LoadASCIIFromString(&model, &error, &warning, container.json.data(),
                                                          static_cast<unsigned>(container.json.size()), "")
                             : parser.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(),
                                                           static_cast<unsigned>(bytes.size()));
    if (!is_read) refuse(file, "glTF", "tinygltf cannot read it: " + error.substr(0, error.find('\n')));
    return model;
}

/// The same of other JSON.
tinygltf::Model parsed_again(const std::filesystem::path& file, const nlohmann::json& json,
                             const Container& container, Files files) {
    const std::string text = json.dump();
    const Container changed{text, container.bin};
    const Bytes glb = changed.bin.empty() ? Bytes{} : packed_glb(changed);
    return parsed(file, glb, changed, files);
}

}  // namespace

GltfModel read_gltf(const std::filesystem::path& file) {
    const Bytes bytes = read_file(file, limits::file_bytes);
    const Container container = open_container(file, bytes);
    Admission admission(file);
    nlohmann::json json = parse_json(file, container.json);
    Guarded found = guarded(file, json, container, admission);
    const CompressedMeshes compressed = take_out_compressed(json, container);
    GltfModel model{.file = file,
                    .gltf = compressed.empty() ? parsed(file, bytes, container, found.buffers)
                                               : parsed_again(file, json, container, found.buffers),
                    .images = {},
                    .notes = std::move(found.notes)};
    put_indices_back(compressed, model.gltf);
    for (std::string& note : check_model(file, model.gltf)) model.notes.push_back(std::move(note));
    decode_compressed(file, compressed, model.gltf);
    read_images(admission, model);
    return model;
}

}  // namespace zproof
