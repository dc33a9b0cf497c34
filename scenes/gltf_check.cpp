#include "scenes/gltf_check.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "scenes/gltf_schema.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

/// Extensions that change nothing that is baked, or that the loader follows.
constexpr std::array known_extensions{"KHR_texture_transform",      "KHR_mesh_quantization",
                                      "KHR_materials_unlit",        "KHR_lights_punctual",
                                      "KHR_materials_ior",          "KHR_materials_sheen",
                                      "KHR_materials_clearcoat",    "KHR_materials_specular",
                                      "KHR_materials_iridescence",  "KHR_materials_anisotropy",
                                      "KHR_materials_transmission", "KHR_materials_volume",
                                      "KHR_materials_dispersion",   "KHR_materials_emissive_strength"};

bool is_known(const std::string& extension) {
    return std::ranges::find(known_extensions, extension) != known_extensions.end();
}

std::string pointer(const char* list, std::size_t index, const char* member = "") {
    return std::string("/") + list + "/" + std::to_string(index) + member;
}

void check_perspective(const Path& file, const std::string& place, const json& intrinsics) {
    const double yfov = intrinsics["yfov"], near = intrinsics["znear"];
    if (!(yfov > 0 && yfov < std::numbers::pi))
        refuse(file, place + "/yfov", "expected an angle between 0 and pi");
    if (!(near > 0)) refuse(file, place + "/znear", "expected a distance above 0");
    if (intrinsics.contains("zfar") && !(intrinsics["zfar"].get<double>() > near))
        refuse(file, place + "/zfar", "expected a distance above znear");
    if (intrinsics.contains("aspectRatio") && !(intrinsics["aspectRatio"].get<double>() > 0))
        refuse(file, place + "/aspectRatio", "expected a ratio above 0");
}

void check_orthographic(const Path& file, const std::string& place, const json& intrinsics) {
    const double near = intrinsics["znear"], far = intrinsics["zfar"];
    for (const char* side : {"/xmag", "/ymag"})
        if (!(intrinsics[json::json_pointer(side)].get<double>() > 0))
            refuse(file, place + side, "expected a magnification above 0");
    if (!(near >= 0)) refuse(file, place + "/znear", "expected a distance of 0 or more");
    if (!(far > near)) refuse(file, place + "/zfar", "expected a distance above znear");
}

void check_data_uri(const Path& file, const std::string& place, const std::string& uri) {
    const std::size_t first = uri.find(',') + 1;
    if (!tinygltf::IsDataURI(uri))
        refuse(file, place, "expected data:TYPE;base64, with an octet-stream, gltf-buffer, PNG or JPEG type");
    const std::size_t end = std::min(uri.find('=', first), uri.size());
    const auto is_base64 = [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' ||
               c == '/';
    };
    for (std::size_t i = first; i < end; ++i)
        if (!is_base64(uri[i])) refuse(file, place, "not base64 at character " + std::to_string(i - first));
}

bool is_data(const std::string& uri) { return uri.starts_with("data:"); }

void admit_buffer(Admitted& admitted, const Path& file, const Container& container, const json& gltf,
                  std::size_t i) {
    const json& buffer = gltf["buffers"][i];
    const std::uint64_t bytes = buffer["byteLength"];
    const std::string place = pointer("buffers", i);
    if (!buffer.contains("uri")) {
        if (i > 0 || !container.bin)
            refuse(file, place, "has no uri; only the first buffer of a GLB with a BIN chunk may lack it");
        if (container.bin->size() < bytes)
            refuse(file, place + "/byteLength",
                   "the BIN chunk has only " + std::to_string(container.bin->size()) + " bytes");
        return;
    }
    const std::string uri = buffer["uri"];
    if (!is_data(uri)) return admitted.admit_buffer(place + "/uri", uri, bytes);
    check_data_uri(file, place + "/uri", uri);
    const std::size_t first = uri.find(',') + 1, end = std::min(uri.find('=', first), uri.size());
    if ((end - first) * 3 / 4 != bytes)
        refuse(file, place + "/byteLength",
               "the data URI holds " + std::to_string((end - first) * 3 / 4) + " bytes");
}

void admit_image(Admitted& admitted, const Path& file, const json& gltf, std::size_t i) {
    const json& image = gltf["images"][i];
    if (!image.contains("uri")) return;
    const std::string uri = image["uri"];
    if (is_data(uri)) return check_data_uri(file, pointer("images", i, "/uri"), uri);
    admitted.admit_image(pointer("images", i, "/uri"), uri);
}

}  // namespace

std::vector<std::string> check_extensions(const Path& file, const json& gltf) {
    const json& needed = list_of(gltf, "extensionsRequired");
    for (std::size_t i = 0; i < needed.size(); ++i)
        if (const std::string name = needed[i]; !is_known(name))
            refuse(file, pointer("extensionsRequired", i),
                   "extension " + name + " is not supported; export the file without it");
    std::string ignored;
    for (const std::string name : list_of(gltf, "extensionsUsed"))
        if (!is_known(name)) ignored += (ignored.empty() ? "" : ", ") + name;
    if (ignored.empty()) return {};
    return {on_one_line("extensions ignored: " + ignored)};
}

void check_cameras(const Path& file, const json& gltf) {
    const json& cameras = list_of(gltf, "cameras");
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const std::string type = cameras[i]["type"];
        const std::string place = pointer("cameras", i, "/") + type;
        if (type != "perspective" && type != "orthographic")
            refuse(file, pointer("cameras", i, "/type"), "expected \"perspective\" or \"orthographic\"");
        if (!cameras[i].contains(type)) refuse(file, place, "is missing; a camera of this type requires it");
        type == "perspective" ? check_perspective(file, place, cameras[i][type])
                              : check_orthographic(file, place, cameras[i][type]);
    }
}

std::set<int> images_in_use(const json& gltf) {
    std::set<int> images;
    for (const json& material : list_of(gltf, "materials")) {
        const json::json_pointer index("/pbrMetallicRoughness/baseColorTexture/index");
        if (!material.contains(index)) continue;
        const json& texture = gltf["textures"][material[index].get<std::size_t>()];
        if (texture.contains("source")) images.insert(texture["source"].get<int>());
    }
    return images;
}

Admitted admit_files(const Path& file, const json& gltf, const Container& container) {
    Admitted admitted(file);
    for (std::size_t i = 0; i < list_of(gltf, "buffers").size(); ++i)
        admit_buffer(admitted, file, container, gltf, i);
    const json& images = list_of(gltf, "images");
    for (std::size_t i = 0; i < images.size(); ++i)
        if (images[i].contains("uri") == images[i].contains("bufferView"))
            refuse(file, pointer("images", i), "expected either uri or bufferView");
    for (const int i : images_in_use(gltf)) admit_image(admitted, file, gltf, static_cast<std::size_t>(i));
    return admitted;
}

}  // namespace zproof
