#include <array>
#include <optional>
#include <string>

#include "scenes/gltf_check.h"
#include "scenes/gltf_schema.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

std::uint64_t integer_or(const json& object, const char* name, std::uint64_t otherwise) {
    return object.value(name, otherwise);
}

std::uint64_t component_bytes(const json& component_type) {
    const int type = component_type;
    return type <= 5121 ? 1 : type <= 5123 ? 2 : 4;
}

/// Components of an accessor type, or 0 for a type that glTF does not have.
std::uint64_t components_of(const std::string& type) {
    constexpr std::array<std::pair<const char*, int>, 7> types{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
    for (const auto& [name, components] : types)
        if (type == name) return static_cast<std::uint64_t>(components);
    return 0;
}

/// Elements in a row: where they start in their buffer view, how far apart, how long.
struct Run {
    std::uint64_t offset = 0, stride = 0, size = 0, count = 0;
};

/// Sums and products of integers up to limits::json_integer and strides up to 255 stay below 2^49.
void check_run(const Path& file, const std::string& place, const json& view, const Run& run) {
    const std::uint64_t length = view["byteLength"];
    if (run.stride < run.size)
        refuse(file, place,
               "byteStride " + std::to_string(run.stride) + " is less than an element's " +
                   std::to_string(run.size) + " bytes");
    if (run.offset + run.stride * (run.count - 1) + run.size > length)
        refuse(file, place,
               std::to_string(run.count) + " elements of " + std::to_string(run.size) +
                   " bytes from byteOffset " + std::to_string(run.offset) +
                   " run past the end of their buffer view of " + std::to_string(length) + " bytes");
}

class Ranges {
  public:
    Ranges(const Path& file, const json& gltf) : file_(file), gltf_(gltf) {}

    void check_view(std::size_t i) const {
        const json& view = gltf_["bufferViews"][i];
        const std::string place = "/bufferViews/" + std::to_string(i);
        const std::uint64_t bytes = gltf_["buffers"][view["buffer"].get<std::size_t>()]["byteLength"];
        if (integer_or(view, "byteOffset", 0) + view["byteLength"].get<std::uint64_t>() > bytes)
            refuse(file_, place, "runs past the end of its buffer of " + std::to_string(bytes) + " bytes");
        const std::uint64_t stride = integer_or(view, "byteStride", 4);
        if (stride < 4 || stride > 252 || stride % 4 != 0)
            refuse(file_, place + "/byteStride", "expected a multiple of 4 from 4 to 252");
    }

    void check_accessor(std::size_t i) const {
        const json& accessor = gltf_["accessors"][i];
        const std::string place = "/accessors/" + std::to_string(i);
        const std::uint64_t components = components_of(accessor["type"]);
        if (components == 0)
            refuse(file_, place + "/type", "expected SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
        for (const char* bound : {"min", "max"})
            if (accessor.contains(bound) && accessor[bound].size() != components)
                refuse(file_, place + "/" + bound, "expected " + std::to_string(components) + " numbers");
        const std::uint64_t size = components * component_bytes(accessor["componentType"]);
        if (accessor.contains("bufferView")) check_elements(place, accessor, accessor["count"], size);
        if (accessor.contains("sparse")) check_sparse(place + "/sparse", accessor, size);
    }

    void check_primitive(std::size_t mesh, std::size_t i) const {
        const json& primitive = gltf_["meshes"][mesh]["primitives"][i];
        const std::string place = "/meshes/" + std::to_string(mesh) + "/primitives/" + std::to_string(i);
        std::optional<std::uint64_t> count;
        for (const auto& [name, index] : primitive["attributes"].items()) {
            const json& accessor = gltf_["accessors"][index.get<std::size_t>()];
            if (count.value_or(accessor["count"]) != accessor["count"])
                refuse(file_, place + "/attributes/" + name,
                       "expected as many elements as the other attributes");
            count = accessor["count"];
            check_attribute(place + "/attributes/" + name, name, accessor);
        }
        if (primitive.contains("indices"))
            check_indices(place + "/indices", gltf_["accessors"][primitive["indices"].get<std::size_t>()]);
    }

  private:
    const json& view_of(const json& reference) const {
        return gltf_["bufferViews"][reference["bufferView"].get<std::size_t>()];
    }

    void check_elements(const std::string& place, const json& at, std::uint64_t count,
                        std::uint64_t size) const {
        const json& view = view_of(at);
        check_run(file_, place, view,
                  {integer_or(at, "byteOffset", 0), integer_or(view, "byteStride", size), size, count});
    }

    void check_sparse(const std::string& place, const json& accessor, std::uint64_t size) const {
        const json& sparse = accessor["sparse"];
        const std::uint64_t count = sparse["count"];
        if (count > accessor["count"])
            refuse(file_, place + "/count", "expected at most the accessor's count");
        const std::uint64_t index_size = component_bytes(sparse["indices"]["componentType"]);
        for (const char* part : {"indices", "values"})
            if (view_of(sparse[part]).contains("byteStride"))
                refuse(file_, place + "/" + part, "expected a buffer view without byteStride");
        check_elements(place + "/indices", sparse["indices"], count, index_size);
        check_elements(place + "/values", sparse["values"], count, size);
    }

    bool has_quantization() const {
        for (const std::string name : list_of(gltf_, "extensionsUsed"))
            if (name == "KHR_mesh_quantization") return true;
        return false;
    }

    void check_attribute(const std::string& place, const std::string& name, const json& accessor) const {
        const std::string type = accessor["type"];
        const int component = accessor["componentType"];
        const bool is_float = component == 5126;
        const bool is_normalized = accessor.value("normalized", false);
        if (name == "POSITION" || name == "NORMAL") {
            if (type != "VEC3" || !(is_float || (has_quantization() && component <= 5123)))
                refuse(file_, place,
                       "expected VEC3 of FLOAT, or 8 and 16 bit integers with KHR_mesh_quantization");
        } else if (name.starts_with("TEXCOORD_")) {
            const bool is_core = (component == 5121 || component == 5123) && is_normalized;
            if (type != "VEC2" || !(is_float || is_core || (has_quantization() && component <= 5123)))
                refuse(file_, place,
                       "expected VEC2 of FLOAT or of normalized UNSIGNED_BYTE or UNSIGNED_SHORT");
        } else if (name.starts_with("COLOR_")) {
            const bool is_core = (component == 5121 || component == 5123) && is_normalized;
            if ((type != "VEC3" && type != "VEC4") || !(is_float || is_core))
                refuse(file_, place,
                       "expected VEC3 or VEC4 of FLOAT or of normalized UNSIGNED_BYTE or UNSIGNED_SHORT");
        }
    }

    void check_indices(const std::string& place, const json& accessor) const {
        const int component = accessor["componentType"];
        const bool is_unsigned = component == 5121 || component == 5123 || component == 5125;
        if (accessor["type"] != "SCALAR" || !is_unsigned || accessor.value("normalized", false))
            refuse(file_, place, "expected SCALAR of UNSIGNED_BYTE, UNSIGNED_SHORT or UNSIGNED_INT");
    }

    const Path& file_;
    const json& gltf_;
};

}  // namespace

void check_ranges(const Path& file, const json& gltf) {
    const Ranges ranges(file, gltf);
    for (std::size_t i = 0; i < list_of(gltf, "bufferViews").size(); ++i) ranges.check_view(i);
    for (std::size_t i = 0; i < list_of(gltf, "accessors").size(); ++i) ranges.check_accessor(i);
    const json& meshes = list_of(gltf, "meshes");
    for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh)
        for (std::size_t i = 0; i < meshes[mesh]["primitives"].size(); ++i) ranges.check_primitive(mesh, i);
}

}  // namespace zproof
