#include "scenes/glb_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "scenes/glb_buffer.h"
#include "scenes/png_encoder.h"
#include "scenes/scene_error.h"
#include "scenes/view_document.h"

namespace zproof {

namespace {

using nlohmann::json;

/// The vertices that a part may use: all from its own first one to the next part's first one, where the
/// parts' vertices follow one another as the parts do, so that a loader counts them as they are counted here;
/// otherwise from the lowest to the highest index used.
std::vector<ElementRange> vertex_ranges(const Scene& scene) {
    struct Used {
        std::size_t low = std::numeric_limits<std::size_t>::max(), end = 0;
    };
    std::vector<Used> used(scene.parts.size());
    for (std::size_t p = 0; p < used.size(); ++p)
        for (std::uint32_t i = 0; i < scene.parts[p].triangle_count; ++i) {
            const glm::uvec3& t = scene.triangles[scene.parts[p].first_triangle + i];
            used[p].low = std::min<std::size_t>(used[p].low, std::min({t.x, t.y, t.z}));
            used[p].end = std::max<std::size_t>(used[p].end, std::max({t.x, t.y, t.z}) + std::size_t{1});
        }
    const bool in_sequence = std::ranges::adjacent_find(used, [](const Used& a, const Used& b) {
                                 return a.end > b.low || a.end == 0 || b.end == 0;
                             }) == used.end();
    std::vector<ElementRange> ranges;
    for (std::size_t p = 0; p < used.size(); ++p) {
        Used whole = used[p];
        if (in_sequence && p == 0) whole.low = 0;
        if (in_sequence)
            whole.end = p + 1 < used.size() ? used[p + 1].low : scene.vertices.position_world.size();
        ranges.push_back({whole.low, whole.end > whole.low ? whole.end - whole.low : 0});
    }
    return ranges;
}

/// bufferViews of the whole scene's attributes; a part's accessors are windows into them.
struct AttributeViews {
    int position = 0, index = 0, normal = -1, color = -1;
    std::vector<int> uv;
};

class GlbDocument {
  public:
    explicit GlbDocument(const Scene& scene) : scene_(scene) {
        add_attributes();
        add_mesh();
        for (const Image& image : scene.images) add_image(image);
        for (const Material& material : scene.materials) add_material(material);
    }

    /// Header, JSON chunk, BIN chunk: glTF 2.0, section 4.4.
    std::string bytes() {
        document_["asset"] = {{"version", "2.0"}, {"generator", "zproof"}};
        document_["scene"] = 0;
        document_["scenes"] = json::array({{{"nodes", {0}}}});
        if (!buffer_.bytes().empty()) {
            document_["buffers"] = json::array({{{"byteLength", buffer_.bytes().size()}}});
            document_["bufferViews"] = buffer_.views();
        }
        if (!buffer_.accessors().empty()) document_["accessors"] = buffer_.accessors();
        std::string text = document_.dump(-1, ' ', false, json::error_handler_t::replace);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::size_t size = 12 + 8 + text.size() + 8 + buffer_.bytes().size();
        if (size > std::numeric_limits<std::uint32_t>::max())
            throw SceneError("scene '" + scene_.name + "': " + std::to_string(size) +
                             " bytes do not fit a GLB, which ends at 4 GiB; split the scene");
        return "glTF" + word(2) + word(size) + word(text.size()) + "JSON" + text +
               word(buffer_.bytes().size()) + std::string("BIN\0", 4) + buffer_.bytes();
    }

  private:
    static std::string word(std::size_t value) {
        const auto little_endian = static_cast<std::uint32_t>(value);
        return {reinterpret_cast<const char*>(&little_endian), 4};
    }

    template <class Element, class Allocator>
    int vertex_view(const std::vector<Element, Allocator>& attribute) {
        return buffer_.add_view(bytes_of(std::span(attribute)),
                                {{"target", 34962}, {"byteStride", sizeof(Element)}});
    }

    void add_attributes() {
        const Vertices& vertices = scene_.vertices;
        if (vertices.position_world.empty()) return;
        views_.position = vertex_view(vertices.position_world);
        if (!vertices.normal_world.empty()) views_.normal = vertex_view(vertices.normal_world);
        for (const auto& uv : vertices.uv) views_.uv.push_back(vertex_view(uv));
        if (!vertices.color.empty()) views_.color = vertex_view(vertices.color);
    }

    void add_mesh() {
        const std::vector<ElementRange> ranges = vertex_ranges(scene_);
        std::vector<std::uint32_t> indices;
        indices.reserve(3 * scene_.triangles.size());
        for (std::size_t p = 0; p < ranges.size(); ++p)
            for (std::uint32_t i = 0; i < scene_.parts[p].triangle_count; ++i)
                for (const int corner : {0, 1, 2})
                    indices.push_back(scene_.triangles[scene_.parts[p].first_triangle + i][corner] -
                                      static_cast<std::uint32_t>(ranges[p].first));
        json node = {{"name", scene_.name}};
        if (!indices.empty()) {
            views_.index =
                buffer_.add_view(bytes_of(std::span<const std::uint32_t>(indices)), {{"target", 34963}});
            add_primitives(ranges);
            node["mesh"] = 0;
        }
        document_["nodes"] = json::array({node});
    }

    void add_primitives(const std::vector<ElementRange>& ranges) {
        json primitives = json::array();
        std::size_t first_index = 0;
        for (std::size_t p = 0; p < ranges.size(); ++p) {
            const std::size_t count = 3 * std::size_t{scene_.parts[p].triangle_count};
            if (count == 0) continue;
            const int indices = buffer_.add_accessor(
                views_.index, {.component_type = 5125, .type = "SCALAR", .bytes = 4}, {first_index, count});
            primitives.push_back({{"attributes", attributes(ranges[p])},
                                  {"indices", indices},
                                  {"material", scene_.parts[p].material}});
            first_index += count;
        }
        document_["meshes"] = json::array({{{"name", scene_.name}, {"primitives", primitives}}});
    }

    json attributes(ElementRange range) {
        json accessors = {{"POSITION", position_accessor(range)}};
        if (views_.normal >= 0 && any_normal(range))
            accessors["NORMAL"] = buffer_.add_accessor(views_.normal, {.type = "VEC3", .bytes = 12}, range);
        for (std::size_t set = 0; set < views_.uv.size(); ++set)
            accessors["TEXCOORD_" + std::to_string(set)] =
                buffer_.add_accessor(views_.uv[set], {.type = "VEC2", .bytes = 8}, range);
        if (views_.color >= 0)
            accessors["COLOR_0"] = buffer_.add_accessor(views_.color, {.type = "VEC4", .bytes = 16}, range);
        return accessors;
    }

    /// Vertices without a normal hold 0, which glTF does not allow as a normal.
    bool any_normal(ElementRange range) const {
        const auto normals = std::span(scene_.vertices.normal_world).subspan(range.first, range.count);
        return std::ranges::any_of(normals, [](const glm::vec3& n) { return n != glm::vec3(0); });
    }

    int position_accessor(ElementRange range) {
        const auto positions = std::span(scene_.vertices.position_world).subspan(range.first, range.count);
        glm::vec3 low = positions.front(), high = low;
        for (const glm::vec3& p_world : positions) {
            low = glm::min(low, p_world);
            high = glm::max(high, p_world);
        }
        return buffer_.add_bounded_accessor(views_.position, range, std::span(&low.x, 3),
                                            std::span(&high.x, 3));
    }

    void add_image(const Image& image) {
        const int view = buffer_.add_view(encode_png(image), json::object());
        document_["images"].push_back(
            {{"name", image.name}, {"mimeType", "image/png"}, {"bufferView", view}});
    }

    void add_material(const Material& material) {
        const glm::vec4& c = material.base_color_factor;
        json surface = {
            {"baseColorFactor", {c.r, c.g, c.b, c.a}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
        if (material.base_color.image != Texture::none)
            surface["baseColorTexture"] = add_texture(material.base_color);
        // Double-sided: zproof draws both faces of every triangle, and so must whoever reads this file.
        document_["materials"].push_back(
            {{"name", material.name}, {"doubleSided", true}, {"pbrMetallicRoughness", surface}});
    }

    json add_texture(const Texture& texture) {
        document_["samplers"].push_back(sampler(texture.sampler));
        document_["textures"].push_back(
            {{"sampler", document_["samplers"].size() - 1}, {"source", texture.image}});
        json use = {{"index", document_["textures"].size() - 1}, {"texCoord", texture.uv_set}};
        const json transform = uv_transform(texture.transform);
        if (!transform.empty()) {
            use["extensions"] = {{"KHR_texture_transform", transform}};
            document_["extensionsUsed"] = {"KHR_texture_transform"};
        }
        return use;
    }

    static json sampler(const Sampler& sampler) {
        const auto wrap = [](Wrap w) {
            return w == Wrap::repeat ? 10497 : w == Wrap::clamp_to_edge ? 33071 : 33648;
        };
        constexpr std::array minification{9728, 9729, 9984,
                                          9985, 9986, 9987};  // in the order of the enumeration
        return {{"wrapS", wrap(sampler.wrap_u)},
                {"wrapT", wrap(sampler.wrap_v)},
                {"magFilter", sampler.magnification == Magnification::nearest ? 9728 : 9729},
                {"minFilter", minification.at(static_cast<std::size_t>(sampler.minification))}};
    }

    /// Offset, rotation and scale whose product is the transform; exact where nothing is rotated, otherwise
    /// within a few ulps. KHR_texture_transform: the columns are scale.x (cos, -sin) and scale.y (sin, cos).
    static json uv_transform(const UvTransform& transform) {
        const glm::dmat2& m = transform.linear;
        json written = json::object();
        if (transform.translation != glm::dvec2(0))
            written["offset"] = {transform.translation.x, transform.translation.y};
        if (m == glm::dmat2(1.0)) return written;
        if (m[0][1] == 0 && m[1][0] == 0) {
            written["scale"] = {m[0][0], m[1][1]};
            return written;
        }
        const double scale_x = std::hypot(m[0][0], m[0][1]),
                     determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        written["rotation"] = std::atan2(-m[0][1], m[0][0]);
        written["scale"] = {scale_x, std::copysign(std::hypot(m[1][0], m[1][1]), determinant)};
        return written;
    }

    const Scene& scene_;
    GlbBuffer buffer_;
    AttributeViews views_;
    json document_;
};

/// Writes the file under another name first, so that a reader sees the old file or the whole new one.
void write_atomically(const std::filesystem::path& file, const std::string& content) {
    std::filesystem::path unfinished = file;
    unfinished += ".part";
    std::ofstream out(unfinished, std::ios::binary | std::ios::trunc);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    std::error_code error;
    if (out) std::filesystem::rename(unfinished, file, error);
    if (out && !error) return;
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw SceneError(file.string() + ": cannot write " + std::to_string(content.size()) +
                     " bytes; check that the folder exists, may be written and has room");
}

/// The scene's name becomes the name of two files, and a JSON string.
void require_file_name(const std::string& name) {
    if (name.empty() || name.front() == '.' ||
        name.find_first_of(std::string("/\\\0", 3)) != std::string::npos)
        throw SceneError("scene '" + name +
                         "': expected a name that can be a file's: no slash, no leading dot");
    try {
        json(name).dump();
    } catch (const json::exception&) {
        throw SceneError("scene '" + name + "': expected a name in UTF-8");
    }
}

}  // namespace

void write_glb_file(const std::filesystem::path& file, const Scene& scene) {
    write_atomically(file, GlbDocument(scene).bytes());
}

void write_glb(const std::filesystem::path& folder, const Loaded& loaded) {
    const std::string& name = loaded.scene.name;
    require_file_name(name);
    write_glb_file(folder / (name + ".glb"), loaded.scene);
    write_atomically(folder / (name + ".view.json"), view_document(name + ".glb", loaded.views));
}

}  // namespace zproof
