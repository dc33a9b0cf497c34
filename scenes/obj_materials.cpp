#include "scenes/obj_materials.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "scenes/limits.h"
#include "scenes/refusal.h"
#include "scenes/scene_error.h"
#include "scenes/scene_files.h"
#include "scenes/texture_image.h"

namespace zproof {
namespace {

using Path = std::filesystem::path;

/// The name with the slashes of POSIX.
std::string with_slashes(std::string name) {
    std::ranges::replace(name, '\\', '/');
    return name;
}

Bytes bytes_beneath(const Path& file, const std::string& place, const std::string& name) {
    return read_file(beneath_folder_of(file, place, name), limits::file_bytes);
}

/// The image's index in the scene, which reads each once.
int image_index(const Path& file, const std::string& place, const std::string& name, Scene& scene) {
    const auto known = std::ranges::find(scene.images, name, &Image::name);
    if (known != scene.images.end()) return static_cast<int>(known - scene.images.begin());
    const Bytes bytes = bytes_beneath(file, place, name);
    if (const std::string fault = image_fault(bytes); !fault.empty())
        refuse(file, place, name + ": " + fault);
    const ImageExtent extent = image_extent(bytes);
    std::uint64_t texels = extent.width * extent.height;
    for (const Image& image : scene.images) texels += image.texels.size() / 4;
    if (texels > limits::all_texels)
        refuse(file, place,
               "too many texels: at most " + std::to_string(limits::all_texels) + " in all images");
    Image image = decode_image(bytes);
    image.name = name;
    scene.images.push_back(std::move(image));
    return static_cast<int>(scene.images.size()) - 1;
}

glm::vec4 factor_of(const tinyobj::material_t& material) {
    glm::vec4 factor(1.0f);
    for (int c = 0; c < 3; ++c)
        if (std::isfinite(material.diffuse[c])) factor[c] = std::clamp(material.diffuse[c], 0.0f, 1.0f);
    return factor;
}

/// Appends a material; without its texture where that cannot be read.
void append(const Path& file, const std::string& place, const Path& folder,
            const tinyobj::material_t& material, Scene& scene) {
    Material baked{on_one_line(material.name), factor_of(material), {}};
    try {
        if (!material.diffuse_texname.empty()) {
            const Path name = folder / with_slashes(material.diffuse_texname);
            baked.base_color.image =
                image_index(file, place, name.lexically_normal().generic_string(), scene);
        }
    } catch (const std::runtime_error& error) {
        scene.notes.push_back(on_one_line("materials untextured: " + baked.name + ": " + error.what()));
    }
    if (material.diffuse_texopt.clamp)
        baked.base_color.sampler.wrap_u = baked.base_color.sampler.wrap_v = Wrap::clamp_to_edge;
    scene.materials.push_back(std::move(baked));
}

}  // namespace

void read_obj_materials(const Path& file, const std::string& place, std::string name, Scene& scene) {
    name = with_slashes(std::move(name));
    std::istringstream text;
    try {
        text.str(std::string(text_in(name, bytes_beneath(file, place, name))));
    } catch (const SceneError& error) {
        scene.notes.push_back(on_one_line(std::string("materials white: ") + error.what()));
        return;
    }
    std::map<std::string, int> by_name;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    tinyobj::LoadMtl(&by_name, &materials, &text, &warning, &error);
    for (const tinyobj::material_t& material : materials)
        append(file, place, Path(name).parent_path(), material, scene);
}

}  // namespace zproof
