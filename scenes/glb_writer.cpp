#include "scenes/glb_writer.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <stdexcept>

#include "frame/frame_error.h"
#include "frame/whole_file.h"
#include "image_io/image_io.h"
#include "scenes/scene_error.h"
#include "scenes/view_document.h"

namespace zproof {

namespace {

static_assert(std::endian::native == std::endian::little,
              "GLB is little-endian, and so must this machine be");

/// A run of elements of an attribute.
struct ElementRange {
    std::size_t first = 0, count = 0;
};

constexpr int no_material = -1;  ///< of a tinygltf::Primitive

/// The scene's parts; one of all triangles where it has none. Throws SceneError where a triangle is in no
/// part: the ids of those after it would not be counted as the scene counts them.
std::vector<Part> parts_of(const Scene& scene) {
    const auto triangles = static_cast<std::uint32_t>(scene.triangles.size());
    if (scene.parts.empty() && triangles > 0)
        return {{.node = {}, .mesh = {}, .triangle_count = triangles, .material = no_material}};
    std::uint64_t next = 0;
    for (const Part& part : scene.parts) {
        if (part.first_triangle != next) break;
        next += part.triangle_count;
    }
    if (next == triangles) return scene.parts;
    throw SceneError("scene '" + scene.name + "': triangle " + std::to_string(next) + " of " +
                     std::to_string(triangles) + " begins no part; expected parts that follow one another");
}

/// The vertices that a part may use: all from its own first one to the next part's first one, where the
/// parts' vertices follow one another as the parts do, so that a loader counts them as they are counted here;
/// otherwise from the lowest to the highest index used.
std::vector<ElementRange> vertex_ranges(const Scene& scene, const std::vector<Part>& parts) {
    struct Used {
        std::size_t low = std::numeric_limits<std::size_t>::max(), end = 0;
    };
    std::vector<Used> used(parts.size());
    for (std::size_t p = 0; p < used.size(); ++p)
        for (std::uint32_t i = 0; i < parts[p].triangle_count; ++i) {
            const glm::uvec3& t = scene.triangles[parts[p].first_triangle + i];
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

template <class Element, class Allocator>
std::span<const unsigned char> bytes_of(const std::vector<Element, Allocator>& elements) {
    return {reinterpret_cast<const unsigned char*>(elements.data()), elements.size() * sizeof(Element)};
}

/// The text with U+FFFD in place of what is not UTF-8, which tinygltf refuses to write.
std::string utf8(const std::string& text) {
    using nlohmann::json;
    return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

/// How the elements of an attribute are read, and where they begin in the buffer.
struct Attribute {
    std::size_t first_byte = 0;
    int component_type = TINYGLTF_COMPONENT_TYPE_FLOAT, type = TINYGLTF_TYPE_VEC3;
    std::size_t element_bytes = 0;
    int target = TINYGLTF_TARGET_ARRAY_BUFFER;
};

std::string png_of(const Image& image) {
    try {
        const std::vector<std::byte> png = encode_png({image.width, image.height}, image.texels);
        return {reinterpret_cast<const char*>(png.data()), png.size()};
    } catch (const std::runtime_error& e) {
        throw SceneError("image '" + image.name + "': " + e.what());
    }
}

/// The scene in tinygltf's structures.
class GlbModel {
  public:
    explicit GlbModel(const Scene& scene) : scene_(scene), parts_(parts_of(scene)) {
        model_.asset.version = "2.0";
        model_.asset.generator = "zproof";
        model_.defaultScene = 0;
        model_.scenes.emplace_back().nodes = {0};
        // Without a mesh and a name, tinygltf would write null in the place of the node.
        model_.nodes.emplace_back().name = scene.name.empty() ? "scene" : utf8(scene.name);
        model_.buffers.emplace_back();
        add_mesh();
        for (const Image& image : scene.images) add_image(image);
        for (const Material& material : scene.materials) add_material(material);
        if (buffer().empty()) model_.buffers.clear();
    }

    const tinygltf::Model& model() const { return model_; }

  private:
    std::vector<unsigned char>& buffer() { return model_.buffers.front().data; }

    /// Appends bytes at a multiple of 4 and returns where they begin.
    std::size_t append(std::span<const unsigned char> bytes) {
        const std::size_t first = buffer().size();
        buffer().insert(buffer().end(), bytes.begin(), bytes.end());
        buffer().resize((buffer().size() + 3) / 4 * 4);
        return first;
    }

    int add_view(std::size_t first_byte, std::size_t bytes) {
        tinygltf::BufferView& view = model_.bufferViews.emplace_back();
        view.buffer = 0;
        view.byteOffset = first_byte;
        view.byteLength = bytes;
        return static_cast<int>(model_.bufferViews.size()) - 1;
    }

    /// A view and an accessor of some elements of an attribute.
    int add_accessor(const Attribute& attribute, ElementRange range) {
        tinygltf::Accessor& accessor = model_.accessors.emplace_back();
        accessor.bufferView = add_view(attribute.first_byte + range.first * attribute.element_bytes,
                                       range.count * attribute.element_bytes);
        accessor.componentType = attribute.component_type;
        accessor.type = attribute.type;
        accessor.count = range.count;
        model_.bufferViews.back().target = attribute.target;
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    template <class Element, class Allocator>
    Attribute vertex_attribute(const std::vector<Element, Allocator>& elements, int type) {
        return {.first_byte = append(bytes_of(elements)), .type = type, .element_bytes = sizeof(Element)};
    }

    void add_mesh() {
        const std::vector<ElementRange> ranges = vertex_ranges(scene_, parts_);
        const std::vector<std::uint32_t> indices = indices_within(ranges);
        if (indices.empty()) return;
        const Vertices& vertices = scene_.vertices;
        position_ = vertex_attribute(vertices.position_world, TINYGLTF_TYPE_VEC3);
        normal_ = vertex_attribute(vertices.normal_world, TINYGLTF_TYPE_VEC3);
        color_ = vertex_attribute(vertices.color, TINYGLTF_TYPE_VEC4);
        for (const auto& uv : vertices.uv) uv_.push_back(vertex_attribute(uv, TINYGLTF_TYPE_VEC2));
        const Attribute index{append(bytes_of(indices)), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                              TINYGLTF_TYPE_SCALAR, sizeof(std::uint32_t),
                              TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER};
        model_.nodes.front().mesh = 0;
        tinygltf::Mesh& mesh = model_.meshes.emplace_back();
        mesh.name = utf8(scene_.name);
        std::size_t first_index = 0;
        for (std::size_t p = 0; p < ranges.size(); ++p) {
            const std::size_t count = 3 * std::size_t{parts_[p].triangle_count};
            if (count == 0) continue;
            tinygltf::Primitive& primitive = mesh.primitives.emplace_back();
            primitive.mode = TINYGLTF_MODE_TRIANGLES;
            primitive.indices = add_accessor(index, {first_index, count});
            primitive.material = parts_[p].material;
            add_attributes(ranges[p], primitive);
            first_index += count;
        }
    }

    /// The corners of all parts, counted from the first vertex of the part's range.
    std::vector<std::uint32_t> indices_within(const std::vector<ElementRange>& ranges) const {
        std::vector<std::uint32_t> indices;
        indices.reserve(3 * scene_.triangles.size());
        for (std::size_t p = 0; p < ranges.size(); ++p)
            for (std::uint32_t i = 0; i < parts_[p].triangle_count; ++i)
                for (const int corner : {0, 1, 2})
                    indices.push_back(scene_.triangles[parts_[p].first_triangle + i][corner] -
                                      static_cast<std::uint32_t>(ranges[p].first));
        return indices;
    }

    void add_attributes(ElementRange range, tinygltf::Primitive& primitive) {
        primitive.attributes["POSITION"] = add_accessor(position_, range);
        add_bounds(range);
        if (any_normal(range)) primitive.attributes["NORMAL"] = add_accessor(normal_, range);
        for (std::size_t set = 0; set < uv_.size(); ++set)
            primitive.attributes["TEXCOORD_" + std::to_string(set)] = add_accessor(uv_[set], range);
        if (!scene_.vertices.color.empty()) primitive.attributes["COLOR_0"] = add_accessor(color_, range);
    }

    /// Vertices without a normal hold 0, which glTF does not allow as a normal.
    bool any_normal(ElementRange range) const {
        if (scene_.vertices.normal_world.empty()) return false;
        const auto normals = std::span(scene_.vertices.normal_world).subspan(range.first, range.count);
        return std::ranges::any_of(normals, [](const glm::vec3& n) { return n != glm::vec3(0); });
    }

    /// Positions must have them.
    void add_bounds(ElementRange range) {
        const auto positions = std::span(scene_.vertices.position_world).subspan(range.first, range.count);
        glm::vec3 low = positions.front(), high = low;
        for (const glm::vec3& p_world : positions) {
            low = glm::min(low, p_world);
            high = glm::max(high, p_world);
        }
        model_.accessors.back().minValues = {low.x, low.y, low.z};
        model_.accessors.back().maxValues = {high.x, high.y, high.z};
    }

    void add_image(const Image& image) {
        const std::string png = png_of(image);
        tinygltf::Image& written = model_.images.emplace_back();
        written.name = utf8(image.name);
        written.mimeType = "image/png";
        written.bufferView =
            add_view(append({reinterpret_cast<const unsigned char*>(png.data()), png.size()}), png.size());
    }

    void add_material(const Material& material) {
        const glm::vec4& c = material.base_color_factor;
        tinygltf::Material& written = model_.materials.emplace_back();
        written.name = utf8(material.name);
        // Double-sided: zproof draws both faces of every triangle, and so must whoever reads this file.
        written.doubleSided = true;
        written.pbrMetallicRoughness.baseColorFactor = {c.r, c.g, c.b, c.a};
        written.pbrMetallicRoughness.metallicFactor = 0;
        if (material.base_color.image != Texture::none)
            written.pbrMetallicRoughness.baseColorTexture = add_texture(material.base_color);
    }

    tinygltf::TextureInfo add_texture(const Texture& texture) {
        tinygltf::Texture& written = model_.textures.emplace_back();
        written.sampler = static_cast<int>(model_.samplers.size());
        written.source = texture.image;
        model_.samplers.push_back(sampler(texture.sampler));
        tinygltf::TextureInfo use;
        use.index = static_cast<int>(model_.textures.size()) - 1;
        use.texCoord = texture.uv_set;
        if (auto transform = uv_transform(texture.transform); !transform.empty()) {
            use.extensions["KHR_texture_transform"] = tinygltf::Value(std::move(transform));
            model_.extensionsUsed = {"KHR_texture_transform"};
        }
        return use;
    }

    static tinygltf::Sampler sampler(const Sampler& sampler) {
        const auto wrap = [](Wrap w) {
            return w == Wrap::repeat          ? TINYGLTF_TEXTURE_WRAP_REPEAT
                   : w == Wrap::clamp_to_edge ? TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE
                                              : TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
        };
        constexpr std::array minification{9728, 9729, 9984,
                                          9985, 9986, 9987};  // in the order of the enumeration
        tinygltf::Sampler written;
        written.wrapS = wrap(sampler.wrap_u);
        written.wrapT = wrap(sampler.wrap_v);
        written.magFilter = sampler.magnification == Magnification::nearest ? TINYGLTF_TEXTURE_FILTER_NEAREST
                                                                            : TINYGLTF_TEXTURE_FILTER_LINEAR;
        written.minFilter = minification.at(static_cast<std::size_t>(sampler.minification));
        return written;
    }

    static tinygltf::Value pair(double x, double y) {
        return tinygltf::Value(tinygltf::Value::Array{tinygltf::Value(x), tinygltf::Value(y)});
    }

    /// Offset, rotation and scale whose product is the transform; exact where nothing is rotated, otherwise
    /// within a few ulps. KHR_texture_transform: the columns are scale.x (cos, -sin) and scale.y (sin, cos).
    static tinygltf::Value::Object uv_transform(const UvTransform& transform) {
        const glm::dmat2& m = transform.linear;
        tinygltf::Value::Object written;
        if (transform.translation != glm::dvec2(0))
            written["offset"] = pair(transform.translation.x, transform.translation.y);
        if (m == glm::dmat2(1.0)) return written;
        if (m[0][1] == 0 && m[1][0] == 0) {
            written["scale"] = pair(m[0][0], m[1][1]);
            return written;
        }
        const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        written["rotation"] = tinygltf::Value(std::atan2(-m[0][1], m[0][0]));
        written["scale"] =
            pair(std::hypot(m[0][0], m[0][1]), std::copysign(std::hypot(m[1][0], m[1][1]), determinant));
        return written;
    }

    const Scene& scene_;
    const std::vector<Part> parts_;
    tinygltf::Model model_;
    Attribute position_, normal_, color_;
    std::vector<Attribute> uv_;
};

void write_whole(const std::filesystem::path& file, const std::string& content) {
    try {
        write_whole_file(file, content);
    } catch (const FrameError& e) {
        throw SceneError(e.what());
    }
}

/// The scene's name becomes the name of two files, and a JSON string.
void require_file_name(const std::string& name) {
    if (name.empty() || name.front() == '.' ||
        name.find_first_of(std::string("/\\\0", 3)) != std::string::npos)
        throw SceneError("scene '" + name +
                         "': expected a name that can be a file's: no slash, no leading dot");
    try {
        nlohmann::json(name).dump();
    } catch (const nlohmann::json::exception&) {
        throw SceneError("scene '" + name + "': expected a name in UTF-8");
    }
}

}  // namespace

std::string glb_bytes(const Scene& scene) {
    std::ostringstream out;
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&GlbModel(scene).model(), out, false, true);
    std::string bytes = std::move(out).str();
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
        throw SceneError("scene '" + scene.name + "': " + std::to_string(bytes.size()) +
                         " bytes do not fit a GLB, which ends at 4 GiB; split the scene");
    return bytes;
}

void write_glb_file(const std::filesystem::path& file, const Scene& scene) {
    write_whole(file, glb_bytes(scene));
}

void write_glb(const std::filesystem::path& folder, const Loaded& loaded) {
    const std::string& name = loaded.scene.name;
    require_file_name(name);
    write_glb_file(folder / (name + ".glb"), loaded.scene);
    write_whole(folder / (name + ".view.json"), view_document(name + ".glb", loaded.views));
}

}  // namespace zproof
