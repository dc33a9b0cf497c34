#include "scenes/gltf/check.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;

enum class ValueKind {
    text,
    uri,  ///< a string; an empty one would name the file itself
    boolean,
    number,
    positive,  ///< a number above 0
    numbers,   ///< an array of numbers whose length is among `choices`
    integer,   ///< 0 or more
    count,     ///< 1 or more
    stride,
    one_of,     ///< JSON among `choices`
    reference,  ///< an index into the array that `choices` names
};

/// A rule about the members at a path. In a path, '*' stands for every element of an array, '{}' for every
/// member of an object, and '|' parts members for which the same holds. A member whose name ends in '!' is
/// required where the object around it is there.
struct Rule {
    std::string_view path;
    ValueKind kind;
    std::string_view choices = {};  ///< set apart by blanks
};

using enum ValueKind;

const Rule rules[] = {
    {"asset!/version!|minVersion", text},
    {"meshes|nodes|scenes|materials|images|cameras/*/name", text},
    {"extensionsUsed|extensionsRequired/*", text},
    {"extensions/KHR_lights_punctual/lights/*/type!", text},
    {"extensions/KHR_lights_punctual/lights/*/spot/innerConeAngle|outerConeAngle", number},
    {"buffers/*/byteLength!", count},
    {"buffers|images/*/uri", uri},
    {"bufferViews/*/buffer!", reference, "buffers"},
    {"bufferViews/*/byteLength!", count},
    {"bufferViews/*/byteStride", stride},
    {"bufferViews|accessors/*/byteOffset", integer},
    {"bufferViews/*/extensions/EXT_meshopt_compression|KHR_meshopt_compression/buffer!", reference,
     "buffers"},
    {"bufferViews/*/extensions/EXT_meshopt_compression|KHR_meshopt_compression/"
     "byteLength!|byteStride!|count!",
     count},
    {"bufferViews/*/extensions/EXT_meshopt_compression|KHR_meshopt_compression/byteOffset", integer},
    {"bufferViews/*/extensions/EXT_meshopt_compression|KHR_meshopt_compression/mode!", one_of,
     R"("ATTRIBUTES" "TRIANGLES" "INDICES")"},
    {"bufferViews/*/extensions/EXT_meshopt_compression|KHR_meshopt_compression/filter", one_of,
     R"("NONE" "OCTAHEDRAL" "QUATERNION" "EXPONENTIAL")"},
    {"accessors/*/bufferView", reference, "bufferViews"},
    {"accessors/*/count!", count},
    {"accessors/*/componentType!", one_of, "5120 5121 5122 5123 5125 5126"},
    {"accessors/*/normalized", boolean},
    {"accessors/*/type!", one_of, R"("SCALAR" "VEC2" "VEC3" "VEC4" "MAT2" "MAT3" "MAT4")"},
    {"accessors/*/min|max", numbers, "1 2 3 4 9 16"},
    {"accessors/*/sparse/count!", count},
    {"accessors/*/sparse/indices!|values!/bufferView!", reference, "bufferViews"},
    {"accessors/*/sparse/indices!|values!/byteOffset", integer},
    {"accessors/*/sparse/indices!/componentType!", one_of, "5121 5123 5125"},
    {"meshes/*/primitives!/*/attributes!/{}", reference, "accessors"},
    {"meshes/*/primitives!/*/targets/*/{}", reference, "accessors"},
    {"meshes/*/primitives!/*/indices", reference, "accessors"},
    {"meshes/*/primitives!/*/extensions/KHR_draco_mesh_compression/bufferView!", reference, "bufferViews"},
    {"meshes/*/primitives!/*/extensions/KHR_draco_mesh_compression/attributes!/{}", integer},
    {"meshes/*/primitives!/*/material", reference, "materials"},
    {"meshes/*/primitives!/*/mode", one_of, "0 1 2 3 4 5 6"},
    {"nodes/*/children/*", reference, "nodes"},
    {"meshes|nodes/*/weights/*", number},
    {"nodes/*/mesh", reference, "meshes"},
    {"nodes/*/camera", reference, "cameras"},
    {"nodes/*/skin", reference, "skins"},
    {"nodes/*/matrix", numbers, "16"},
    {"nodes/*/translation|scale", numbers, "3"},
    {"nodes/*/rotation", numbers, "4"},
    {"scenes/*/nodes/*", reference, "nodes"},
    {"scene", reference, "scenes"},
    {"materials/*/emissiveFactor", numbers, "3"},
    {"materials/*/pbrMetallicRoughness/baseColorFactor", numbers, "4"},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/index!", reference, "textures"},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/texCoord", integer},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset|scale",
     numbers, "2"},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/rotation", number},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/texCoord", integer},
    {"materials/*/normalTexture|occlusionTexture|emissiveTexture/index!", reference, "textures"},
    {"textures/*/sampler", reference, "samplers"},
    {"textures/*/source", reference, "images"},
    {"samplers/*/magFilter", one_of, "9728 9729"},
    {"samplers/*/minFilter", one_of, "9728 9729 9984 9985 9986 9987"},
    {"samplers/*/wrapS|wrapT", one_of, "10497 33071 33648"},
    {"images/*/mimeType", text},
    {"images/*/bufferView", reference, "bufferViews"},
    {"cameras/*/type!", one_of, R"("perspective" "orthographic")"},
    {"cameras/*/perspective/yfov!|znear!|zfar|aspectRatio", positive},
    {"cameras/*/orthographic/xmag!|ymag!", positive},
    {"cameras/*/orthographic/znear!|zfar!", number},
    {"skins/*/joints!/*", reference, "nodes"},
    {"skins/*/skeleton", reference, "nodes"},
    {"skins/*/inverseBindMatrices", reference, "accessors"},
    {"animations/*/samplers/*/input!|output!", integer},
};

/// Whether the word is one of those that blanks set apart.
bool is_among(const std::string& words, const std::string& word) {
    return word.find(' ') == std::string::npos &&
           (' ' + words + ' ').find(' ' + word + ' ') != std::string::npos;
}

/// Whether the value is an integer from `least` to below `end`.
bool is_within(const json& value, std::uint64_t least, std::uint64_t end) {
    return value.is_number_unsigned() && value.get<std::uint64_t>() >= least &&
           value.get<std::uint64_t>() < end;
}

bool are_numbers(const json& value) {
    return value.is_array() && std::ranges::all_of(value, [](const json& each) { return each.is_number(); });
}

class Walk {
  public:
    Walk(const std::filesystem::path& file, const json& gltf) : file_(file), gltf_(gltf) {}

    void apply(const Rule& rule) {
        rule_ = &rule;
        descend(gltf_, rule.path);
    }

  private:
    void descend(const json& at, std::string_view path) {
        const std::size_t slash = path.find('/');
        const std::string_view rest = slash == std::string_view::npos ? "" : path.substr(slash + 1);
        std::string_view keys = path.substr(0, slash);
        if (keys == "*") return each_element(at, rest);
        if (!at.is_object()) refuse_found(at, "an object");
        if (keys == "{}") return each_member(at, rest);
        while (!keys.empty()) {
            const std::string_view key = keys.substr(0, keys.find('|'));
            member(at, key, rest);
            keys.remove_prefix(std::min(key.size() + 1, keys.size()));
        }
    }

    void enter(const json& value, std::string_view key, std::string_view rest) {
        const std::size_t length = place_.size();
        (place_ += '/') += key;
        rest.empty() ? check(value) : descend(value, rest);
        place_.resize(length);
    }

    void each_element(const json& at, std::string_view rest) {
        if (!at.is_array()) refuse_found(at, "an array");
        for (std::size_t i = 0; i < at.size(); ++i) enter(at[i], std::to_string(i), rest);
    }

    void each_member(const json& at, std::string_view rest) {
        for (const auto& [name, value] : at.items()) enter(value, name, rest);
    }

    void member(const json& at, std::string_view key, std::string_view rest) {
        const bool is_required = key.ends_with('!');
        if (is_required) key.remove_suffix(1);
        if (const auto found = at.find(key); found != at.end()) return enter(*found, key, rest);
        if (is_required) refuse(file_, place_ + "/" + std::string(key), "is missing; glTF 2.0 requires it");
    }

    [[noreturn]] void refuse_found(const json& value, const std::string& expected) const {
        refuse(file_, place_.empty() ? "/" : place_,
               "expected " + expected + ", found " + value.dump().substr(0, 60));
    }

    void check(const json& value) const {
        if (const std::string expected = expectation(value); !expected.empty()) refuse_found(value, expected);
    }

    /// What was expected where the value is not it, or nothing.
    std::string expectation(const json& value) const {
        const std::string choices(rule_->choices);
        switch (rule_->kind) {
            case text:
                return value.is_string() ? "" : "a string";
            case uri:
                return value.is_string() && value != "" ? "" : "a URI";
            case boolean:
                return value.is_boolean() ? "" : "true or false";
            case number:
                return value.is_number() ? "" : "a number";
            case positive:
                return value.is_number() && value.get<double>() > 0 ? "" : "a number above 0";
            case numbers:
                return are_numbers(value) && is_among(choices, std::to_string(value.size()))
                           ? ""
                           : "an array of numbers, how many: " + choices;
            case integer:
                return is_within(value, 0, limits::json_integer + 1) ? "" : "an integer from 0 to 2^31 - 1";
            case count:
                return is_within(value, 1, limits::json_integer + 1) ? "" : "an integer from 1 to 2^31 - 1";
            case stride:
                return is_within(value, 4, 253) && value.get<int>() % 4 == 0
                           ? ""
                           : "a multiple of 4 from 4 to 252";
            case one_of:
                return is_among(choices, value.dump()) ? "" : "one of " + choices;
            case reference:
                return is_within(value, 0, size_of(choices))
                           ? ""
                           : "an index into " + choices + ", which has " + std::to_string(size_of(choices)) +
                                 " elements";
        }
        return {};
    }

    std::size_t size_of(std::string_view list) const {
        const auto found = gltf_.find(list);
        return found == gltf_.end() ? 0 : found->size();
    }

    const std::filesystem::path& file_;
    const json& gltf_;
    const Rule* rule_ = nullptr;
    std::string place_;
};

void check_lights(const std::filesystem::path& file, const json& gltf) {
    const json lights =
        gltf.value(json::json_pointer("/extensions/KHR_lights_punctual/lights"), json::array());
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i]["type"] == "spot" && !lights[i].contains("spot"))
            refuse(file, pointer("extensions/KHR_lights_punctual/lights", i, "/spot"),
                   "is missing; a light of this type requires it");
}

}  // namespace

void check_schema(const std::filesystem::path& file, const json& gltf) {
    Walk walk(file, gltf);
    for (const Rule& rule : rules) walk.apply(rule);
    check_lights(file, gltf);
    const std::string version = gltf["asset"]["version"];
    if (!version.starts_with("2."))
        refuse(file, "/asset/version",
               "expected 2.0, found \"" + version + "\"; convert the file to glTF 2.0");
    const std::string least = gltf["asset"].value("minVersion", "2.0");
    if (least != "2.0" && !least.starts_with("1."))
        refuse(file, "/asset/minVersion",
               "expected at most 2.0, found \"" + least + "\"; convert the file to glTF 2.0");
}

}  // namespace zproof
