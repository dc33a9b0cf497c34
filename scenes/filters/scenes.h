/// The filter scenes, one function each, and what they are built from.
#pragma once

#include <array>

#include "scenes/filters/textures.h"
#include "scenes/loaded.h"
#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/views.h"

namespace zproof::filters {

using suite::ImageSize;

/// A vertex with its place on the texture, in texture widths and heights.
struct Corner {
    glm::dvec3 p_world{0};
    glm::vec2 uv{0};
};

/// An image repeated in both directions, uv as it stands.
inline Texture image_texture(int image) {
    Texture texture;
    texture.image = image;
    return texture;
}

/// A mesh whose vertices have texture coordinates.
class TexturedMesh {
  public:
    explicit TexturedMesh(const std::string& scene_name) : mesh_(scene_name) {}

    /// A new part; the texture's image is an index into finish's images. Parts that show the same share a
    /// material.
    void begin_part(const std::string& node, const Texture& texture);
    void triangle(const std::array<Corner, 3>& corners);
    void quad(const std::array<Corner, 4>& corners);
    Loaded finish(std::vector<Image> images, std::vector<View> views);

  private:
    void vertex(const Corner& corner);

    suite::MeshBuilder mesh_;
    std::uint32_t vertex_count_ = 0;
    Bulk<glm::vec2> uv_;
    std::vector<Texture> textures_;
};

/// The ground y = 0 as one triangle that reaches to the horizon, seen from the eye of the worked set-up
/// (height 1, pitched down by 20 degrees, 60 degrees high) in steps of `step` degrees from 0 to 90: 128
/// texels to a unit, texel (3.37, 1.71) below the eye.
Loaded ground(const std::string& name, Image image, ImageSize size, double step = 7.5);

// planes.cpp
Loaded worked(ImageSize size);
Loaded checker_plane(ImageSize size);
Loaded zone_plate_plane(ImageSize size);
Loaded lines_plane(ImageSize size);
Loaded text_plane(ImageSize size);
Loaded white_noise_plane(ImageSize size);
Loaded pink_noise_plane(ImageSize size);
Loaded impulse_plane(ImageSize size);
Loaded npot_plane(ImageSize size);
Loaded npot_odd_plane(ImageSize size);

// charts.cpp
Loaded tilted_quads(ImageSize size);
Loaded lod_ramp(ImageSize size);
Loaded magnification(ImageSize size);
Loaded seams(ImageSize size);
Loaded uneven_strips(ImageSize size);

// tunnel.cpp
Loaded tunnel(ImageSize size);

}  // namespace zproof::filters
