#include "scenes/gltf_model.h"

#include "scenes/gltf_check.h"
#include "scenes/gltf_images.h"
#include "scenes/gltf_limits.h"
#include "scenes/gltf_schema.h"
#include "scenes/gltf_structure.h"
#include "scenes/json_text.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

const Bytes& keep(GltfModel& model, Bytes bytes) {
    return *model.bytes.emplace_back(std::make_unique<const Bytes>(std::move(bytes)));
}

Bytes decoded(const std::string& data_uri) {
    std::vector<unsigned char> bytes;
    std::string type;
    tinygltf::DecodeDataURI(&bytes, type, data_uri, 0, false);
    return {bytes.begin(), bytes.end()};
}

/// The bytes of a buffer, which were found to be there when its file was admitted.
std::span<const unsigned char> buffer_of(const json& buffer, const Container& container,
                                         const Admitted& admitted, GltfModel& model) {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) return *container.bin;
    const std::string& place = uri->get_ref<const std::string&>();
    return keep(model, tinygltf::IsDataURI(place) ? decoded(place) : admitted.read(place));
}

void add_notes(std::vector<std::string> notes, GltfModel& model) {
    for (std::string& note : notes) model.notes.push_back(std::move(note));
}

/// Throws SceneError for anything that may not be relied on from here on.
void check(const json& gltf, GltfModel& model) {
    check_schema(model.file, gltf);
    add_notes(check_extensions(model.file, gltf), model);
    add_notes(check_nodes(model.file, gltf), model);
    check_ranges(model.file, gltf);
    check_cameras(model.file, gltf);
}

}  // namespace

GltfModel read_gltf(const Path& file) {
    GltfModel model;
    model.file = file;
    const Bytes& bytes = keep(model, read_file(file, limits::file_bytes));
    const Container container = open_container(file, bytes);
    const json gltf = parse_json(file, container.json);
    check(gltf, model);
    const Admitted admitted = admit_files(file, gltf, container);
    model.gltf = structure_of(gltf);
    for (const json& buffer : list_of(gltf, "buffers"))
        model.buffers.push_back(buffer_of(buffer, container, admitted, model).first(buffer["byteLength"]));
    read_images(gltf, admitted, model);
    return model;
}

}  // namespace zproof
