#include "oracle/povray/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "frame/number_text.h"
#include "oracle/oracle_error.h"
#include "oracle/povray/camera.h"
#include "oracle/povray/geometry.h"
#include "oracle/povray/text.h"
#include "oracle/povray/texture.h"

namespace zproof::oracle {
namespace {

constexpr std::size_t most_textures = 65536;

/// A list of mesh2 with its length in front: "vertex_vectors{2,<..>,<..>}".
class List {
  public:
    explicit List(std::string name) : name_(std::move(name)) {}
    std::size_t add(const std::string& entry) {
        entries_ += "," + entry;
        return count_++;
    }
    std::size_t size() const { return count_; }
    std::string text() const {
        return count_ == 0 ? "" : name_ + "{" + std::to_string(count_) + entries_ + "}\n";
    }

  private:
    std::string name_, entries_;
    std::size_t count_ = 0;
};

std::string indices(const std::array<std::size_t, 3>& i) {
    return "<" + std::to_string(i[0]) + "," + std::to_string(i[1]) + "," + std::to_string(i[2]) + ">";
}

std::string colour_text(const glm::dvec3& colour) {
    return "rgb<" + shortest(colour.r) + "," + shortest(colour.g) + "," + shortest(colour.b) + ">";
}

/// Everything that the mesh is made of, collected triangle by triangle.
class MeshWriter {
  public:
    MeshWriter(const Scene& scene, const View& view, double scale)
        : scene_(scene),
          eye_world_(view.camera.eye_world),
          scale_(scale),
          material_textures_(scene.materials.size()) {
        for (const glm::vec3& p_world : scene.vertices.position_world)
            positions_.add(vector_text(scale_ * (glm::dvec3(p_world) - eye_world_)));
        for (const glm::vec3& n : scene.vertices.normal_world) normals_.add(vector_text(glm::dvec3(n)));
        for (const Part& part : scene.parts) add_part(part);
    }

    std::string text(const std::string& clip) const {
        return "mesh2{" + positions_.text() + normals_.text() + uvs_.text() + textures_.text() +
               faces_.text() + normal_faces_.text() + uv_faces_.text() + clip + "}\n";
    }

    std::vector<PovrayImage> images() && { return std::move(images_); }

  private:
    using Corners = std::array<std::size_t, 3>;

    static Corners corners_of(const glm::uvec3& t) { return {t.x, t.y, t.z}; }

    void add_part(const Part& part) {
        const auto material = std::size_t(part.material);
        const bool textured = has_image(scene_.materials[material]);
        if (textured && !scene_.vertices.color.empty())
            throw OracleError("POV-Ray's pictures: a texture times vertex colours, which POV-Ray cannot say");
        for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
            const Corners corners = corners_of(scene_.triangles[part.first_triangle + i]);
            if (has_no_area(corners)) continue;
            faces_.add(indices(corners) + (textured ? "," + std::to_string(image_texture(material))
                                                    : plain_textures(material, corners)));
            if (normals_.size() > 0) normal_faces_.add(indices(normal_indices(corners)));
            uv_faces_.add(
                indices(textured ? uv_indices(material, corners) : Corners{no_uv(), no_uv(), no_uv()}));
        }
    }

    bool has_image(const Material& material) const {
        return material.base_color.image != Texture::none &&
               std::size_t(material.base_color.uv_set) < scene_.vertices.uv.size();
    }

    glm::dvec3 position(std::size_t vertex) const {
        return glm::dvec3(scene_.vertices.position_world[vertex]);
    }

    glm::dvec3 face_normal(const Corners& c) const {
        return glm::cross(position(c[1]) - position(c[0]), position(c[2]) - position(c[0]));
    }

    bool has_no_area(const Corners& corners) const { return face_normal(corners) == glm::dvec3(0); }

    /// A triangle with a corner that has no normal gets its own at all three.
    Corners normal_indices(const Corners& corners) {
        const auto has_normal = [&](std::size_t vertex) {
            return scene_.vertices.normal_world[vertex] != glm::vec3(0);
        };
        if (std::ranges::all_of(corners, has_normal)) return corners;
        const std::size_t own = normals_.add(vector_text(glm::normalize(face_normal(corners))));
        return {own, own, own};
    }

    /// ",7" where the whole triangle is of one colour, ",7,8,7" where colours are the vertices'.
    std::string plain_textures(std::size_t material, const Corners& corners) {
        const glm::vec3 factor(scene_.materials[material].base_color_factor);
        const auto& colours = scene_.vertices.color;
        if (colours.empty()) return "," + std::to_string(plain_texture(factor));
        std::string text;
        for (const std::size_t vertex : corners)
            text += "," + std::to_string(plain_texture(factor * glm::vec3(colours[vertex])));
        return text;
    }

    std::size_t plain_texture(const glm::vec3& colour) {
        const std::array<float, 3> key{colour.r, colour.g, colour.b};
        const auto known = plain_textures_.find(key);
        if (known != plain_textures_.end()) return known->second;
        if (textures_.size() >= most_textures)
            throw OracleError("POV-Ray's pictures: more than 65536 different vertex colours");
        return plain_textures_[key] =
                   textures_.add("texture{pigment{" + colour_text(glm::dvec3(colour)) + "}}");
    }

    struct ImageTexture {
        PovrayTexture texture;
        std::size_t index = 0;
        std::map<std::size_t, std::size_t> uv_of_vertex{};
    };

    ImageTexture& image_texture_of(std::size_t material) {
        std::optional<ImageTexture>& slot = material_textures_[material];
        if (slot) return *slot;
        const Material& m = scene_.materials[material];
        slot = ImageTexture{povray_texture(scene_, m, uv_range(material)), 0};
        const std::string name = "texture" + std::to_string(images_.size()) + ".png";
        images_.push_back({name, std::move(slot->texture.png)});
        const bool nearest = m.base_color.sampler.magnification == Magnification::nearest;
        slot->index = textures_.add("texture{uv_mapping pigment{image_map{png \"" + name + "\" gamma 1.0" +
                                    (nearest ? "" : " interpolate 2") + "}}}");
        return *slot;
    }

    std::size_t image_texture(std::size_t material) { return image_texture_of(material).index; }

    glm::dvec2 gltf_uv(const Texture& texture, std::size_t vertex) const {
        const glm::vec2 uv = scene_.vertices.uv[std::size_t(texture.uv_set)][vertex];
        return texture.transform.translation + texture.transform.linear * glm::dvec2(uv);
    }

    UvRange uv_range(std::size_t material) const {
        std::optional<UvRange> range;
        for (const Part& part : scene_.parts) {
            if (std::size_t(part.material) != material) continue;
            for (std::uint32_t i = 0; i < part.triangle_count; ++i)
                for (const std::size_t vertex : corners_of(scene_.triangles[part.first_triangle + i])) {
                    const glm::dvec2 uv = gltf_uv(scene_.materials[material].base_color, vertex);
                    if (!range) range = UvRange{uv, uv};
                    range = UvRange{glm::min(range->lowest, uv), glm::max(range->highest, uv)};
                }
        }
        return range.value_or(UvRange{});
    }

    Corners uv_indices(std::size_t material, const Corners& corners) {
        ImageTexture& image = image_texture_of(material);
        Corners found{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [place, is_new] = image.uv_of_vertex.try_emplace(corners[i], uvs_.size());
            if (is_new)
                uvs_.add(
                    uv_text(image.texture.uv(gltf_uv(scene_.materials[material].base_color, corners[i]))));
            found[i] = place->second;
        }
        return found;
    }

    static std::string uv_text(const glm::dvec2& uv) {
        return "<" + shortest(uv.x) + "," + shortest(uv.y) + ">";
    }

    /// mesh2 wants coordinates for all faces or for none.
    std::size_t no_uv() {
        if (!no_uv_) no_uv_ = uvs_.add("<0,0>");
        return *no_uv_;
    }

    const Scene& scene_;
    glm::dvec3 eye_world_;
    double scale_;
    List positions_{"vertex_vectors"}, normals_{"normal_vectors"}, uvs_{"uv_vectors"},
        textures_{"texture_list"};
    List faces_{"face_indices"}, normal_faces_{"normal_indices"}, uv_faces_{"uv_indices"};
    std::map<std::array<float, 3>, std::size_t> plain_textures_;
    std::vector<std::optional<ImageTexture>> material_textures_;
    std::optional<std::size_t> no_uv_;
    std::vector<PovrayImage> images_;
};

/// The light is at infinity, as far as parallel light is concerned. `shadows` says how it goes without any.
std::string light_text(const Camera& c, const Light& light, const PovrayUnits& units,
                       const std::string& shadows) {
    const glm::dvec3 l = light.toward_camera;
    const glm::dvec3 toward_world = l.x * c.right + l.y * c.up + l.z * c.back;
    const double distance = 4 * (units.high + units.origin_reach);
    return "light_source{" + vector_text(distance * toward_world) + " rgb 1 parallel point_at<0,0,0>" +
           shadows + "}\n";
}

}  // namespace

PovrayPicture povray_picture(const Scene& scene, const View& view, const Light& light,
                             const PhongFinish& phong_finish) {
    const PovrayUnits units = povray_geometry(scene, view).units;
    MeshWriter mesh(scene, view, units.scale);
    // A shadowless light makes no highlight (POV-Ray takes it for a fill light), so the mesh is told instead.
    const bool is_glossy = phong_finish.specular > 0;
    const std::string highlight = is_glossy ? " phong " + shortest(phong_finish.specular) + " phong_size " +
                                                  shortest(phong_finish.exponent)
                                            : "";
    std::string text =
        "#version 3.7;\nglobal_settings{assumed_gamma 1 adc_bailout 0}\n#default{finish{ambient " +
        shortest(light.ambient) + " diffuse " + shortest(light.diffuse) + highlight +
        "}}\nbackground{rgb 0}\n" + povray_camera_text(view, units) +
        light_text(view.camera, light, units, is_glossy ? "" : " shadowless") +
        mesh.text(povray_clip_text(view.camera, units) + (is_glossy ? " no_shadow" : ""));
    return {std::move(text), std::move(mesh).images()};
}

}  // namespace zproof::oracle
