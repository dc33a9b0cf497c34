#include "scenes/filters/scenes.h"

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

Loaded TexturedMesh::finish(std::vector<Image> images, std::vector<View> views) {
    Loaded loaded = mesh_.finish(std::move(views));
    loaded.scene.vertices.uv.push_back(std::move(uv_));
    loaded.scene.images = std::move(images);
    for (std::size_t i = 0; i < textures_.size(); ++i) loaded.scene.materials[i].base_color = textures_[i];
    return loaded;
}

}  // namespace zproof::filters
