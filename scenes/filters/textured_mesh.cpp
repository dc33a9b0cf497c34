#include "scenes/filters/scenes.h"

#include <algorithm>

namespace zproof::filters {

void TexturedMesh::begin_part(const std::string& node, const Texture& texture) {
    mesh_.begin_part(node, {1, 1, 1});
    textures_.push_back(texture);
}

void TexturedMesh::vertex(const Corner& corner) {
    vertex_count_ = mesh_.vertex(corner.p_world) + 1;
    uv_.push_back(corner.uv);
}

void TexturedMesh::triangle(const std::array<Corner, 3>& corners) {
    for (const Corner& corner : corners) vertex(corner);
    mesh_.triangle(vertex_count_ - 3, vertex_count_ - 2, vertex_count_ - 1);
}

void TexturedMesh::quad(const std::array<Corner, 4>& corners) {
    for (const Corner& corner : corners) vertex(corner);
    mesh_.quad({vertex_count_ - 4, vertex_count_ - 3, vertex_count_ - 2, vertex_count_ - 1});
}

namespace {

bool show_alike(const Texture& a, const Texture& b) {
    return a.image == b.image && a.sampler.wrap_u == b.sampler.wrap_u &&
           a.sampler.wrap_v == b.sampler.wrap_v && a.transform.linear == b.transform.linear &&
           a.transform.translation == b.transform.translation;
}

}  // namespace

Loaded TexturedMesh::finish(std::vector<Image> images, std::vector<View> views) {
    Loaded loaded = mesh_.finish(std::move(views));
    Scene& scene = loaded.scene;
    scene.vertices.uv.push_back(std::move(uv_));
    scene.images = std::move(images);
    std::vector<Material> distinct;
    for (std::size_t i = 0; i < textures_.size(); ++i) {
        const auto shared = std::ranges::find_if(
            distinct, [&](const Material& other) { return show_alike(other.base_color, textures_[i]); });
        scene.parts[i].material = int(shared - distinct.begin());
        if (shared != distinct.end()) continue;
        distinct.push_back(scene.materials[i]);
        distinct.back().base_color = textures_[i];
        distinct.back().name = scene.images[std::size_t(textures_[i].image)].name;
    }
    scene.materials = std::move(distinct);
    return loaded;
}

}  // namespace zproof::filters
