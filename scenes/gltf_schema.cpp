#include "scenes/gltf_schema.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/gltf_limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;

enum class Kind {
    object,
    array,
    objects,  ///< an array of objects
    string,
    strings,
    boolean,
    number,
    numbers,    ///< an array of numbers; `choices` holds the lengths allowed, none for any length
    integer,    ///< 0 or more
    count,      ///< 1 or more
    one_of,     ///< an integer among `choices`
    reference,  ///< an index into the array `into`
};
enum class Presence { optional, required };

struct Rule {
    std::string_view path;  ///< '*' stands for every element or member
    Kind kind;
    Presence presence = Presence::optional;
    std::initializer_list<std::uint64_t> choices = {};
    std::string_view into = {};
};

constexpr Presence required = Presence::required, optional = Presence::optional;

constexpr Rule refers(std::string_view path, std::string_view into, Presence presence = optional) {
    return {path, Kind::reference, presence, {}, into};
}

/// Parents stand before their members.
const Rule rules[] = {
    {"asset", Kind::object, required},
    {"asset/version", Kind::string, required},
    {"extensionsUsed", Kind::strings},
    {"extensionsRequired", Kind::strings},
    {"buffers", Kind::objects},
    {"buffers/*/byteLength", Kind::count, required},
    {"buffers/*/uri", Kind::string},
    {"bufferViews", Kind::objects},
    refers("bufferViews/*/buffer", "buffers", required),
    {"bufferViews/*/byteOffset", Kind::integer},
    {"bufferViews/*/byteLength", Kind::count, required},
    {"bufferViews/*/byteStride", Kind::integer},
    {"accessors", Kind::objects},
    refers("accessors/*/bufferView", "bufferViews"),
    {"accessors/*/byteOffset", Kind::integer},
    {"accessors/*/count", Kind::count, required},
    {"accessors/*/componentType", Kind::one_of, required, {5120, 5121, 5122, 5123, 5125, 5126}},
    {"accessors/*/normalized", Kind::boolean},
    {"accessors/*/type", Kind::string, required},
    {"accessors/*/min", Kind::numbers, optional, {1, 2, 3, 4, 9, 16}},
    {"accessors/*/max", Kind::numbers, optional, {1, 2, 3, 4, 9, 16}},
    {"accessors/*/sparse", Kind::object},
    {"accessors/*/sparse/count", Kind::count, required},
    {"accessors/*/sparse/indices", Kind::object, required},
    refers("accessors/*/sparse/indices/bufferView", "bufferViews", required),
    {"accessors/*/sparse/indices/byteOffset", Kind::integer},
    {"accessors/*/sparse/indices/componentType", Kind::one_of, required, {5121, 5123, 5125}},
    {"accessors/*/sparse/values", Kind::object, required},
    refers("accessors/*/sparse/values/bufferView", "bufferViews", required),
    {"accessors/*/sparse/values/byteOffset", Kind::integer},
    {"meshes", Kind::objects},
    {"meshes/*/name", Kind::string},
    {"meshes/*/primitives", Kind::objects, required},
    {"meshes/*/primitives/*/attributes", Kind::object, required},
    refers("meshes/*/primitives/*/attributes/*", "accessors"),
    refers("meshes/*/primitives/*/indices", "accessors"),
    refers("meshes/*/primitives/*/material", "materials"),
    {"meshes/*/primitives/*/mode", Kind::one_of, optional, {0, 1, 2, 3, 4, 5, 6}},
    {"meshes/*/primitives/*/targets", Kind::objects},
    refers("meshes/*/primitives/*/targets/*/*", "accessors"),
    {"nodes", Kind::objects},
    {"nodes/*/name", Kind::string},
    {"nodes/*/children", Kind::array},
    refers("nodes/*/children/*", "nodes"),
    refers("nodes/*/mesh", "meshes"),
    refers("nodes/*/camera", "cameras"),
    refers("nodes/*/skin", "skins"),
    {"nodes/*/matrix", Kind::numbers, optional, {16}},
    {"nodes/*/translation", Kind::numbers, optional, {3}},
    {"nodes/*/rotation", Kind::numbers, optional, {4}},
    {"nodes/*/scale", Kind::numbers, optional, {3}},
    {"scenes", Kind::objects},
    {"scenes/*/name", Kind::string},
    {"scenes/*/nodes", Kind::array},
    refers("scenes/*/nodes/*", "nodes"),
    refers("scene", "scenes"),
    {"materials", Kind::objects},
    {"materials/*/name", Kind::string},
    {"materials/*/pbrMetallicRoughness", Kind::object},
    {"materials/*/pbrMetallicRoughness/baseColorFactor", Kind::numbers, optional, {4}},
    {"materials/*/pbrMetallicRoughness/baseColorTexture", Kind::object},
    refers("materials/*/pbrMetallicRoughness/baseColorTexture/index", "textures", required),
    {"materials/*/pbrMetallicRoughness/baseColorTexture/texCoord", Kind::integer},
    {"materials/*/normalTexture", Kind::object},
    refers("materials/*/normalTexture/index", "textures", required),
    {"materials/*/occlusionTexture", Kind::object},
    refers("materials/*/occlusionTexture/index", "textures", required),
    {"materials/*/emissiveTexture", Kind::object},
    refers("materials/*/emissiveTexture/index", "textures", required),
    {"textures", Kind::objects},
    refers("textures/*/sampler", "samplers"),
    refers("textures/*/source", "images"),
    {"samplers", Kind::objects},
    {"samplers/*/magFilter", Kind::one_of, optional, {9728, 9729}},
    {"samplers/*/minFilter", Kind::one_of, optional, {9728, 9729, 9984, 9985, 9986, 9987}},
    {"samplers/*/wrapS", Kind::one_of, optional, {10497, 33071, 33648}},
    {"samplers/*/wrapT", Kind::one_of, optional, {10497, 33071, 33648}},
    {"images", Kind::objects},
    {"images/*/uri", Kind::string},
    {"images/*/mimeType", Kind::string},
    {"images/*/name", Kind::string},
    refers("images/*/bufferView", "bufferViews"),
    {"cameras", Kind::objects},
    {"cameras/*/type", Kind::string, required},
    {"cameras/*/name", Kind::string},
    {"cameras/*/perspective", Kind::object},
    {"cameras/*/perspective/yfov", Kind::number, required},
    {"cameras/*/perspective/znear", Kind::number, required},
    {"cameras/*/perspective/zfar", Kind::number},
    {"cameras/*/perspective/aspectRatio", Kind::number},
    {"cameras/*/orthographic", Kind::object},
    {"cameras/*/orthographic/xmag", Kind::number, required},
    {"cameras/*/orthographic/ymag", Kind::number, required},
    {"cameras/*/orthographic/znear", Kind::number, required},
    {"cameras/*/orthographic/zfar", Kind::number, required},
    {"skins", Kind::objects},
    refers("skins/*/inverseBindMatrices", "accessors"),
    {"skins/*/joints", Kind::array},
    refers("skins/*/joints/*", "nodes"),
    refers("skins/*/skeleton", "nodes"),
    {"animations", Kind::objects},
};

bool is_index(const json& value) {
    return value.is_number_unsigned() && value.get<std::uint64_t>() <= limits::json_integer;
}

bool every(const json& value, bool (json::*is)() const noexcept) {
    return value.is_array() && std::ranges::all_of(value, [is](const json& each) { return (each.*is)(); });
}

bool is_among(std::initializer_list<std::uint64_t> choices, std::uint64_t value) {
    return std::find(choices.begin(), choices.end(), value) != choices.end();
}

/// The phrase "one of 1, 2, 3".
std::string listed(std::initializer_list<std::uint64_t> choices) {
    std::string text;
    for (const std::uint64_t choice : choices)
        text += (text.empty() ? "one of " : ", ") + std::to_string(choice);
    return text;
}

class Walk {
  public:
    Walk(const std::filesystem::path& file, const json& gltf) : file_(file), gltf_(gltf) {}

    void apply(const Rule& rule) {
        rule_ = &rule;
        place_.clear();
        descend(gltf_, rule.path);
    }

  private:
    void descend(const json& at, std::string_view path) {
        const std::size_t slash = path.find('/');
        const std::string_view key = path.substr(0, slash);
        const std::string_view rest = slash == std::string_view::npos ? "" : path.substr(slash + 1);
        if (key == "*")
            each(at, rest);
        else
            member(at, key, rest);
    }

    void enter(const json& value, const std::string& key, std::string_view rest) {
        const std::size_t length = place_.size();
        place_ += '/';
        place_ += key;
        rest.empty() ? check(value) : descend(value, rest);
        place_.resize(length);
    }

    void each(const json& at, std::string_view rest) {
        if (!at.is_structured()) refuse(file_, place_, "expected an array");
        std::size_t index = 0;
        for (auto element = at.begin(); element != at.end(); ++element)
            enter(*element, at.is_object() ? element.key() : std::to_string(index++), rest);
    }

    void member(const json& at, std::string_view key, std::string_view rest) {
        if (!at.is_object()) refuse(file_, place_, "expected an object");
        if (const auto found = at.find(key); found != at.end()) return enter(*found, std::string(key), rest);
        if (rest.empty() && rule_->presence == Presence::required)
            refuse(file_, place_ + "/" + std::string(key), "is missing; glTF 2.0 requires it");
    }

    void check(const json& value) const {
        if (const std::string expected = expectation(value); !expected.empty())
            refuse(file_, place_, "expected " + expected + ", found " + value.dump().substr(0, 60));
    }

    /// What was expected where the value is not it, or nothing.
    std::string expectation(const json& value) const {
        switch (rule_->kind) {
            case Kind::object:
                return value.is_object() ? "" : "an object";
            case Kind::array:
                return value.is_array() ? "" : "an array";
            case Kind::objects:
                return every(value, &json::is_object) ? "" : "an array of objects";
            case Kind::string:
                return value.is_string() ? "" : "a string";
            case Kind::strings:
                return every(value, &json::is_string) ? "" : "an array of strings";
            case Kind::boolean:
                return value.is_boolean() ? "" : "true or false";
            case Kind::number:
                return value.is_number() ? "" : "a number";
            case Kind::numbers:
                return of_numbers(value);
            case Kind::integer:
                return is_index(value) ? "" : "an integer from 0 to 2^40";
            case Kind::count:
                return is_index(value) && value != 0 ? "" : "an integer from 1 to 2^40";
            case Kind::one_of:
                return is_index(value) && is_among(rule_->choices, value) ? "" : listed(rule_->choices);
            case Kind::reference:
                return of_reference(value);
        }
        return {};
    }

    std::string of_numbers(const json& value) const {
        if (!every(value, &json::is_number)) return "an array of numbers";
        return is_among(rule_->choices, value.size()) ? ""
                                                      : "an array whose length is " + listed(rule_->choices);
    }

    std::string of_reference(const json& value) const {
        const auto into = gltf_.find(rule_->into);
        const std::size_t size = into == gltf_.end() ? 0 : into->size();
        if (is_index(value) && value.get<std::uint64_t>() < size) return {};
        return "an index into " + std::string(rule_->into) + ", which has " + std::to_string(size) +
               " elements";
    }

    const std::filesystem::path& file_;
    const json& gltf_;
    const Rule* rule_ = nullptr;
    std::string place_;
};

}  // namespace

const json& list_of(const json& gltf, const char* name) {
    static const json none = json::array();
    const auto found = gltf.find(name);
    return found == gltf.end() ? none : *found;
}

void check_schema(const std::filesystem::path& file, const json& gltf) {
    if (!gltf.is_object()) refuse(file, "/", "expected a glTF object");
    Walk walk(file, gltf);
    for (const Rule& rule : rules) walk.apply(rule);
    const std::string version = gltf["asset"]["version"];
    if (!version.starts_with("2."))
        refuse(file, "/asset/version",
               "expected 2.0, found \"" + version + "\"; convert the file to glTF 2.0");
}

}  // namespace zproof
