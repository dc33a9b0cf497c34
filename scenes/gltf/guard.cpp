#include "scenes/gltf/guard.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "scenes/gltf/compression.h"
#include "scenes/gltf/schema.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

/// Extensions that change nothing that is baked, or that the loader follows.
constexpr std::string_view known_extensions[] = {
    "KHR_texture_transform",      "KHR_mesh_quantization",
    "KHR_materials_unlit",        "KHR_lights_punctual",
    "KHR_materials_ior",          "KHR_materials_sheen",
    "KHR_materials_clearcoat",    "KHR_materials_specular",
    "KHR_materials_iridescence",  "KHR_materials_anisotropy",
    "KHR_materials_transmission", "KHR_materials_volume",
    "KHR_materials_dispersion",   "KHR_materials_emissive_strength"};

bool is_known(const std::string& extension) {
    return std::ranges::find(known_extensions, extension) != std::end(known_extensions);
}

/// The number of bytes that a data URI holds, all of which are base64.
std::size_t data_bytes(const Path& file, const std::string& place, const std::string& uri) {
    const auto is_base64 = [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '/'; };
    const auto first = std::ranges::find(uri, ',') + 1, end = std::find_if_not(first, uri.end(), is_base64);
    if (end != uri.end() && *end != '=')
        refuse(file, place,
               "not base64 at character " + std::to_string(end - first) + "; export the file again");
    if (end - first < 2)
        refuse(file, place, "expected base64 behind the comma, found nothing; export the file again");
    return static_cast<std::size_t>(end - first) * 3 / 4;
}

/// Gives a note for unknown extensions that are not required.
std::vector<std::string> check_extensions(const Path& file, const json& gltf) {
    const json& required = list_of(gltf, "extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i)
        if (const std::string name = required[i]; !is_known(name) && !is_decoded(name))
            refuse(file, pointer("extensionsRequired", i),
                   compressor_of(name).empty()
                       ? "extension " + name + " is not supported; export the file without it"
                       : refusal_of_compression(name));
    std::string ignored;
    for (const std::string name : list_of(gltf, "extensionsUsed"))
        if (!is_known(name) && !is_decoded(name)) ignored += (ignored.empty() ? "" : ", ") + name;
    if (ignored.empty()) return {};
    return {on_one_line("extensions ignored: " + ignored)};
}

void check_view(const Path& file, const json& gltf, std::size_t i) {
    const json& view = gltf["bufferViews"][i];
    const std::uint64_t first = view.value("byteOffset", std::uint64_t{0}), size = view["byteLength"];
    const std::uint64_t bytes = gltf["buffers"][view["buffer"].get<std::size_t>()]["byteLength"];
    if (first + size > bytes)
        refuse(file, pointer("bufferViews", i),
               "needs " + std::to_string(size) + " bytes at " + std::to_string(first) + ", its buffer has " +
                   std::to_string(bytes) + "; export the file again");
}

void check_image(const Path& file, const json& image, std::size_t i) {
    if (image.contains("uri") == image.contains("bufferView"))
        refuse(file, pointer("images", i), "expected either uri or bufferView");
    if (!image.contains("uri")) return;
    const std::string& uri = image["uri"].get_ref<const std::string&>();
    if (tinygltf::IsDataURI(uri)) data_bytes(file, pointer("images", i, "/uri"), uri);
}

void check_indices(const Path& file, const json& gltf, std::size_t mesh) {
    const json& primitives = gltf["meshes"][mesh]["primitives"];
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        for (const auto& [name, extension] : list_of(primitives[i], "extensions").items())
            if (!compressor_of(name).empty() && !is_decoded(name))
                refuse(file, pointer("meshes", mesh, pointer("primitives", i)), refusal_of_compression(name));
        if (const auto indices = primitives[i].find("indices");
            indices != primitives[i].end() && !is_draco_primitive(primitives[i]) &&
            !gltf["accessors"][indices->get<std::size_t>()].contains("bufferView"))
            refuse(file, pointer("meshes", mesh, pointer("primitives", i, "/indices")),
                   "expected an accessor with a bufferView; export the file again");
    }
}

void check_camera(const Path& file, const json& camera, std::size_t i) {
    const std::string type = camera["type"];
    if (!camera.contains(type))
        refuse(file, pointer("cameras", i, "/" + type), "is missing; a camera of this type requires it");
}

/// What is not in a file of its own has all the bytes that the buffer declares.
void check_inner_buffer(const Path& file, const json& buffer, std::size_t i, const Container& container) {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end() && (i > 0 || container.bin.data() == nullptr))
        refuse(file, pointer("buffers", i),
               "has no uri; only the first buffer of a GLB with a BIN chunk may lack it");
    const std::uint64_t declared = buffer["byteLength"];
    const std::size_t there = uri == buffer.end() ? container.bin.size()
                                                  : data_bytes(file, pointer("buffers", i, "/uri"),
                                                               uri->get_ref<const std::string&>());
    if (there < declared || (uri != buffer.end() && there > declared))
        refuse(file, pointer("buffers", i, "/byteLength"),
               std::string("the ") + (uri == buffer.end() ? "BIN chunk" : "data URI") + " holds " +
                   std::to_string(there) + " bytes, expected " + std::to_string(declared) +
                   "; export the file again");
}

}  // namespace

Guarded guarded(const Path& file, const json& gltf, const Container& container, Admission& admission) {
    check_schema(file, gltf);
    Guarded found{.buffers = {}, .notes = check_extensions(file, gltf)};
    for (std::size_t i = 0; i < list_of(gltf, "bufferViews").size(); ++i) check_view(file, gltf, i);
    for (std::size_t i = 0; i < list_of(gltf, "meshes").size(); ++i) check_indices(file, gltf, i);
    check_compression(file, gltf, container);
    for (std::size_t i = 0; i < list_of(gltf, "images").size(); ++i) check_image(file, gltf["images"][i], i);
    for (std::size_t i = 0; i < list_of(gltf, "cameras").size(); ++i)
        check_camera(file, gltf["cameras"][i], i);
    const std::set<std::size_t> without_bytes = stand_ins(gltf, container);
    for (std::size_t i = 0; i < list_of(gltf, "buffers").size(); ++i) {
        const json& buffer = gltf["buffers"][i];
        const std::string* uri =
            buffer.contains("uri") ? buffer["uri"].get_ptr<const std::string*>() : nullptr;
        if (without_bytes.contains(i)) continue;
        if (uri == nullptr || tinygltf::IsDataURI(*uri))
            check_inner_buffer(file, buffer, i, container);
        else
            found.buffers.push_back(
                admission.admit(pointer("buffers", i, "/uri"), *uri, buffer["byteLength"]));
    }
    return found;
}

}  // namespace zproof
