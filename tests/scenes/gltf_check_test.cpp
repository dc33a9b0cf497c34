// Files that contradict glTF or themselves: refused with the place of the fault.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scenes/gltf/compression.h"
#include "scenes/gltf/gltf.h"
#include "scenes/limits.h"
#include "scenes/scene_error.h"
#include "tests/scenes/written_gltf.h"

namespace zproof {
namespace {

using nlohmann::json;

const std::vector<float> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};

/// A value that does not belong at the place of a file of one triangle, and what is said of it.
struct Fault {
    const char *place, *value, *message;
};

void expect_refused(const Fault& fault) {
    SCOPED_TRACE(fault.message);
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(corners);
    gltf.json[json::json_pointer(fault.place)] = json::parse(fault.value);
    const std::string refusal = refusal_of(gltf.write(folder));
    EXPECT_NE(refusal.find(std::string("scene.gltf: ") + fault.message), std::string::npos) << refusal;
}

TEST(GltfCheck, NamesAnIntegerThatIsNone) {
    for (const Fault& fault :
         {Fault{"/accessors/0/byteOffset", R"("4")", "/accessors/0/byteOffset: expected an integer"},
          Fault{"/accessors/0/byteOffset", "null", "/accessors/0/byteOffset: expected an integer"},
          Fault{"/accessors/0/byteOffset", "2147483648", "/accessors/0/byteOffset: expected an integer"},
          Fault{"/accessors/0/count", "4294967299", "/accessors/0/count: expected an integer"},
          Fault{"/nodes/0/mesh", "4294967296", "/nodes/0/mesh: expected an index into meshes, which has 1"},
          Fault{"/nodes/0/mesh", "-1", "/nodes/0/mesh: expected an index into meshes, which has 1"},
          Fault{"/nodes/0/mesh", "0.5", "/nodes/0/mesh: expected an index into meshes, which has 1"},
          Fault{"/scene", "1", "/scene: expected an index into scenes, which has 1"}})
        expect_refused(fault);
}

TEST(GltfCheck, NamesAPrimitiveThatIsNone) {
    for (const Fault& fault :
         {Fault{"/meshes/0/primitives/1", "5", "/meshes/0/primitives/1: expected an object, found 5"},
          Fault{"/meshes/0/primitives/1", "{}", "/meshes/0/primitives/1/attributes: is missing"},
          Fault{"/meshes/0/primitives/0/attributes/POSITION", R"("0")",
                "/meshes/0/primitives/0/attributes/POSITION: expected an index into accessors"},
          Fault{"/meshes/0/primitives", "{}", "/meshes/0/primitives: expected an array, found {}"}})
        expect_refused(fault);
}

TEST(GltfCheck, NamesWhatIsMissingOrOfAWrongLength) {
    for (const Fault& fault :
         {Fault{"/bufferViews/0/byteStride", "6", "/bufferViews/0/byteStride: expected a multiple of 4"},
          Fault{"/skins", "[{}]", "/skins/0/joints: is missing"},
          Fault{"/materials", R"([{"emissiveFactor": [1, 1]}])",
                "/materials/0/emissiveFactor: expected an array"},
          Fault{"/animations", R"([{"samplers": [{"input": 0}]}])",
                "/animations/0/samplers/0/output: is missing"},
          Fault{"/cameras", R"([{"type": "perspective"}])", "/cameras/0/perspective: is missing"},
          Fault{"/images", R"([{"uri": "a.png", "bufferView": 0}])",
                "/images/0: expected either uri or bufferView"},
          Fault{"/images", R"([{"uri": ""}])", "/images/0/uri: expected a URI, found \"\""},
          Fault{"/images", R"([{"uri": "data:image/png;base64,"}])", "/images/0/uri: expected base64"},
          Fault{"/images", R"([{"uri": "data:image/png;base64,A*"}])",
                "/images/0/uri: not base64 at character 1"},
          Fault{"/meshes/0/primitives/0/indices", "0", "/meshes/0/primitives/0/indices: expected SCALAR"}})
        expect_refused(fault);
}

TEST(GltfCheck, NamesABufferViewBeyondItsBuffer) {
    expect_refused({"/bufferViews/0/byteLength", "37",
                    "/bufferViews/0: needs 37 bytes at 0, its buffer has 36; export the file again"});
    expect_refused({"/bufferViews/0/byteOffset", "1",
                    "/bufferViews/0: needs 36 bytes at 1, its buffer has 36; export the file again"});
}

TEST(GltfCheck, NamesTheCompressionThatThisBuildDoesNotDecode) {
    for (const char* name :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const TestFolder folder;
        WrittenGltf gltf;
        gltf.add_vec3(corners);
        gltf.json["extensionsRequired"] = {name};
        const std::string refusal = refusal_of(gltf.write(folder));
        const std::string expected =
            is_decoded(name) ? "loaded" : "/extensionsRequired/0: " + refusal_of_compression(name);
        EXPECT_NE(refusal.find(expected), std::string::npos) << refusal;
    }
    expect_refused({"/extensionsRequired", R"(["KHR_texture_basisu"])",
                    "/extensionsRequired/0: extension KHR_texture_basisu is not supported; export the file "
                    "without it"});
}

TEST(GltfCheck, NamesWhatIsMissingOfACompressedPrimitive) {
    const std::string place = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
    expect_refused({"/meshes/0/primitives/0/extensions", R"({"KHR_draco_mesh_compression": {}})",
                    (place + "/bufferView: is missing").c_str()});
}

TEST(GltfCheck, NamesIndicesWithoutABufferView) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(corners);
    gltf.primitive()["indices"] =
        gltf.add_accessor({{"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}});
    const std::string refusal = refusal_of(gltf.write(folder));
    EXPECT_NE(refusal.find("/meshes/0/primitives/0/indices: expected an accessor with a bufferView"),
              std::string::npos)
        << refusal;
}

TEST(GltfCheck, RefusesTheCharacter0InTextButNotItsEscapeWhenEscaped) {
    const TestFolder folder;
    const std::string before = R"({"asset": {"version": "2.0"}, "nodes": [{"name": ")", after = R"("}]})";
    EXPECT_EQ(refusal_of(folder.write("scene.gltf", before + R"(\\u0000)" + after)), "loaded");
    const std::string refusal = refusal_of(folder.write("scene.gltf", before + R"(\\\u0000)" + after));
    EXPECT_NE(refusal.find("byte 52: expected text without the character 0"), std::string::npos) << refusal;
}

TEST(GltfCheck, RefusesAKeyThatStandsTwice) {
    const TestFolder folder;
    const std::string refusal = refusal_of(
        folder.write("scene.gltf", R"({"asset": {"version": "2.0"}, "meshes": [], "meshes": [{}]})"));
    EXPECT_NE(refusal.find("byte 44: \"meshes\" stands twice in its object; expected each key once"),
              std::string::npos)
        << refusal;
}

TEST(GltfCheck, RefusesMoreObjectsThanStructuresShouldBeMadeOf) {
    const TestFolder folder;
    std::string text = R"({"materials": [)";
    for (std::size_t i = 1; i < limits::json_objects; ++i) text += "{},";
    const std::string refusal = refusal_of(folder.write("scene.gltf", text + "{}]}"));
    EXPECT_NE(refusal.find("too many objects: at most 2097152 objects"), std::string::npos) << refusal;
}

TEST(GltfCheck, ChecksATextureTransform) {
    const std::string use = R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions": )";
    const std::string transform = use + R"({"KHR_texture_transform": {"offset": [1]}}}}}])";
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(corners);
    gltf.json["textures"] = json::array({json::object()});
    gltf.json["materials"] = json::parse(transform);
    const std::string refusal = refusal_of(gltf.write(folder));
    EXPECT_NE(refusal.find("KHR_texture_transform/offset: expected an array of numbers, how many: 2"),
              std::string::npos)
        << refusal;
}

TEST(GltfCheck, NamesNodesThatAreNoTree) {
    for (const Fault& fault :
         {Fault{"/nodes/0/children", "[0]", "/nodes/0: is its own ancestor; expected a tree"},
          Fault{"/nodes", R"([{"children": [1]}, {"children": [2]}, {"children": [1]}])",
                "/nodes/1: is its own ancestor; expected a tree"},
          Fault{"/scenes/0/nodes", "[0, 0]", "/scenes/0/nodes: node 0 is listed twice"},
          Fault{"/nodes", R"([{}, {"children": [0]}])",
                "/scenes/0/nodes: node 0 has a parent; expected roots"}})
        expect_refused(fault);
}

TEST(GltfCheck, NamesANodeThatReadersPlaceDifferently) {
    const std::string matrix = R"("matrix": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1])";
    for (const char* part :
         {R"("translation": [0, 0, 0])", R"("rotation": [0, 0, 0, 1])", R"("scale": [1, 1, 1])"})
        expect_refused({"/nodes", ("[{" + matrix + ", " + part + "}]").c_str(),
                        "/nodes/0: has a matrix beside translation, rotation or scale; expected either"});
}

TEST(GltfCheck, NamesWeightsThatAreNotOneForEachMorphTarget) {
    for (const Fault& fault :
         {Fault{"/nodes/0/weights", "[1]",
                "/nodes/0/weights: has 1 numbers, a primitive of the mesh 0 morph targets; expected as many"},
          Fault{
              "/meshes/0",
              R"({"weights": [1], "primitives": [{"attributes": {"POSITION": 0}, "targets": [{}, {}]}]})",
              "/meshes/0/weights: has 1 numbers, a primitive of the mesh 2 morph targets; expected as many"}})
        expect_refused(fault);
}

TEST(GltfCheck, NamesAVersionThatANewerReaderIsNeededFor) {
    for (const char* version : {"\"2.1\"", "\"3.0\"", "\"10.0\"", "\"\""})
        expect_refused({"/asset/minVersion", version, "/asset/minVersion: expected at most 2.0, found"});
    expect_refused(
        {"/asset", R"({"version": "2.1", "minVersion": "2.1"})", "/asset/minVersion: expected at most 2.0"});
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(corners);
    gltf.json["asset"] = {{"version", "2.1"}, {"minVersion", "2.0"}};
    EXPECT_EQ(refusal_of(gltf.write(folder)), "loaded");
}

TEST(GltfCheck, NamesACameraThatProjectsNothing) {
    for (const Fault& fault :
         {Fault{"/cameras", R"([{"type": "perspective", "perspective": {"yfov": 3.2, "znear": 1}}])",
                "/cameras/0/perspective/yfov: expected an angle between 0 and pi"},
          Fault{"/cameras", R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 1, "zfar": 1}}])",
                "/cameras/0/perspective/zfar: expected a distance above znear"},
          Fault{"/cameras",
                R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 1, "aspectRatio": 0}}])",
                "/cameras/0/perspective/aspectRatio: expected a number above 0"},
          Fault{
              "/cameras",
              R"([{"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": -1, "zfar": 1}}])",
              "/cameras/0/orthographic/znear: expected a distance of 0 or more"}})
        expect_refused(fault);
}

TEST(GltfCheck, NamesASpotLightWithoutACone) {
    expect_refused({"/extensions", R"({"KHR_lights_punctual": {"lights": [{"type": "spot"}]}})",
                    "/extensions/KHR_lights_punctual/lights/0/spot: is missing"});
}

TEST(Gltf, LeavesImagesAloneThatNoMaterialUses) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(corners);
    gltf.json["images"] = json::parse(R"([{"uri": "not_there.png"}, {"uri": "/etc/passwd"},
        {"uri": "data:image/webp;base64,AAAA"}, {"uri": "data:image/png;base64,AAAA"}, {"bufferView": 0}])");
    const std::vector<std::string> notes = load_gltf(gltf.write(folder)).scene.notes;
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0], "images not read, since no base colour texture uses them: 5");
}

/// Both take the first bytes of one file, of different lengths.
TEST(Gltf, ReadsBuffersFromTheirFilesInOrder) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(corners);
    json whole = gltf.json;
    gltf.write(folder);
    folder.write("other.bin", std::string(40, '\0'));
    whole["buffers"] = {{{"uri", "other.bin"}, {"byteLength", 4}},
                        {{"uri", "scene.bin"}, {"byteLength", 36}},
                        {{"uri", "other.bin"}, {"byteLength", 40}}};
    whole["bufferViews"][0]["buffer"] = 1;
    const Scene scene = load_gltf(folder.write("scene.gltf", whole.dump())).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

/// What glTF has beside a mesh.
const char* const everything_else = R"({
    "extensionsUsed": ["KHR_texture_transform", "KHR_lights_punctual"],
    "extensionsRequired": ["KHR_texture_transform"],
    "extensions": {"KHR_lights_punctual": {"lights":
        [{"type": "spot", "color": [1, 1, 1], "spot": {"innerConeAngle": 0}}]}},
    "materials": [{"name": "m", "emissiveFactor": [0, 0, 0], "normalTexture": {"index": 0, "scale": 1},
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0, "baseColorTexture": {
            "index": 0, "texCoord": 0, "extensions": {"KHR_texture_transform": {
                "offset": [0, 0], "rotation": 0.5, "scale": [1, 1], "texCoord": 0}}}}}],
    "textures": [{"sampler": 0, "source": 0}],
    "samplers": [{"magFilter": 9728, "minFilter": 9729, "wrapS": 10497, "wrapT": 10497}],
    "images": [{"name": "i", "uri":
        "data:image/png;base64,)"
                                    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIA"
                                    "AACQd1PeAAAADElEQVR4nGP4z8AA"
                                    R"(AAMBAQDJ/pLvAAAAAElFTkSuQmCC"},
        {"bufferView": 0, "mimeType": "image/png"}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1, "zfar": 2, "aspectRatio": 1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}}],
    "skins": [{"joints": [0], "skeleton": 0, "inverseBindMatrices": 0}],
    "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "scale"}}],
        "samplers": [{"input": 0, "output": 0, "interpolation": "LINEAR"}]}],
    "nodes": [
        {"name": "n", "mesh": 0, "skin": 0, "children": [1, 2], "rotation": [0, 0, 0, 1], "weights": [1]},
        {"camera": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
        {"camera": 1, "translation": [0, 0, 1], "scale": [1, 1, 1], "extensions": {"E": {"a": [1]}},
            "extras": {"b": 2}}]
})";

/// A file that uses everything.
json everything(const TestFolder& folder) {
    WrittenGltf gltf;
    const int position = gltf.add_vec3(corners), index = gltf.add_indices<std::uint16_t>({0, 1, 2}, 5123);
    const int uv = gltf.add_accessor({{"bufferView", gltf.add_view<float>({0, 0, 1, 0, 0, 1})},
                                      {"componentType", 5126},
                                      {"count", 3},
                                      {"type", "VEC2"},
                                      {"min", {0, 0}},
                                      {"max", {1, 1}}});
    gltf.json["accessors"][position]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", gltf.add_view<std::uint8_t>({1})}, {"byteOffset", 0}, {"componentType", 5121}}},
        {"values", {{"bufferView", gltf.add_view<float>({1, 2, 3})}, {"byteOffset", 0}}}};
    gltf.primitive() = {{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv}}},
                        {"indices", index},
                        {"material", 0},
                        {"mode", 4},
                        {"targets", {{{"POSITION", position}}}}};
    gltf.json.update(json::parse(everything_else));
    return json::parse(std::ifstream(gltf.write(folder)));
}

std::vector<json::json_pointer> pointers_into(const json& value,
                                              const json::json_pointer& at = json::json_pointer()) {
    std::vector<json::json_pointer> pointers;
    if (!value.is_structured()) return pointers;
    for (const auto& [name, member] : value.items()) {
        pointers.push_back(value.is_array() ? at / std::stoul(name) : at / name);
        const auto inner = pointers_into(member, pointers.back());
        pointers.insert(pointers.end(), inner.begin(), inner.end());
    }
    return pointers;
}

/// Loaded, or refused in one line that names the file.
void expect_handled(const TestFolder& folder, const json& gltf) {
    const std::filesystem::path file = folder.write("scene.gltf", gltf.dump());
    const std::string refusal = refusal_of(file);
    if (refusal == "loaded") return;
    EXPECT_TRUE(refusal.starts_with(file.string() + ": ")) << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
}

TEST(GltfCheck, LeavesNothingToChanceWhicheverValueIsReplacedOrMissing) {
    const TestFolder folder;
    const json whole = everything(folder);
    ASSERT_EQ(refusal_of(folder.path() / "scene.gltf"), "loaded");
    for (const json::json_pointer& place : pointers_into(whole)) {
        SCOPED_TRACE(place.to_string());
        for (const char* value :
             {"null", "-1", "2147483648", R"("data:image/png;base64,AAAA")", "[null]", R"({"a": []})"}) {
            json changed = whole;
            changed[place] = json::parse(value);
            expect_handled(folder, changed);
        }
        json shorter = whole;
        shorter[place.parent_pointer()].is_array()
            ? shorter[place.parent_pointer()].erase(std::stoul(place.back()))
            : void(shorter[place.parent_pointer()].erase(place.back()));
        expect_handled(folder, shorter);
    }
}

std::string word(std::size_t value) {
    const auto little_endian = static_cast<std::uint32_t>(value);
    return {reinterpret_cast<const char*>(&little_endian), 4};
}

/// A GLB of these chunks behind its JSON, each a type and its content.
std::string glb(const json& gltf, const std::vector<std::pair<std::string, std::string>>& chunks) {
    std::string text = gltf.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string body = word(text.size()) + "JSON" + text;
    for (const auto& [type, content] : chunks) body += word(content.size()) + type + content;
    return "glTF" + word(2) + word(12 + body.size()) + body;
}

TEST(Gltf, ReadsAGlbWithUnusualChunks) {
    const TestFolder folder;
    WrittenGltf gltf;
    const std::string bin("BIN\0", 4), bytes(reinterpret_cast<const char*>(corners.data()), 36);
    const json nothing = {{"asset", {{"version", "2.0"}}}, {"nodes", json::array({json::object()})}};
    for (const auto& chunks : std::vector<std::vector<std::pair<std::string, std::string>>>{
             {}, {{bin, ""}}, {{"ABCD", "1234"}}, {{"ABCD", "1234"}, {"EFGH", ""}}})
        EXPECT_EQ(refusal_of(folder.write("scene.glb", glb(nothing, chunks))), "loaded");
    gltf.add_vec3(corners);
    gltf.json["buffers"] = {{{"byteLength", 36}}};
    EXPECT_EQ(refusal_of(folder.write("scene.glb", glb(gltf.json, {{bin, bytes}, {"ABCD", "1234"}}))),
              "loaded");
    EXPECT_NE(refusal_of(folder.write("scene.glb", glb(gltf.json, {{"ABCD", "1234"}, {bin, bytes}})))
                  .find("expected one JSON chunk, then at most one BIN chunk"),
              std::string::npos);
    EXPECT_NE(refusal_of(folder.write("scene.glb", glb(gltf.json, {{bin, "1234"}})))
                  .find("/buffers/0/byteLength: the BIN chunk holds 4 bytes, expected 36"),
              std::string::npos);
}

}  // namespace
}  // namespace zproof
