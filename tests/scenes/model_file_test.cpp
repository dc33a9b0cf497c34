// OBJ and PLY: the same cube in every format, and what is refused of broken files.
#include "scenes/model_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "scenes/scene_hash.h"
#include "tests/scenes/written_gltf.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// Eight corners; six quads, seen from outside counter-clockwise.
const std::vector<float> cube_corners{-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1,
                                      -1, -1, 1,  1, -1, 1,  1, 1, 1,  -1, 1, 0.1f};
const std::vector<std::array<std::uint32_t, 4>> cube_quads{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                           {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}};

fs::path cube_gltf(const TestFolder& folder) {
    std::vector<std::uint32_t> indices;
    for (const auto& [a, b, c, d] : cube_quads) indices.insert(indices.end(), {a, b, c, a, c, d});
    WrittenGltf gltf;
    gltf.add_vec3(cube_corners);
    gltf.primitive()["indices"] = gltf.add_indices(indices, 5125);
    return gltf.write(folder);
}

/// "0.1 ": the shortest decimals that give the float back.
std::string text_of(float value) { return nlohmann::json(value).dump().substr(0, 4) + " "; }

std::string cube_obj() {
    std::string text = "# a cube\nmtllib none.mtl\no cube\n";
    for (std::size_t i = 0; i < cube_corners.size(); i += 3)
        text += "v " + text_of(cube_corners[i]) + text_of(cube_corners[i + 1]) +
                text_of(cube_corners[i + 2]) + "\n";
    for (std::size_t i = 0; i < cube_quads.size(); ++i) {
        text += i % 2 == 0 ? "g even\nf" : "g odd\nusemtl none\nf";
        for (const std::uint32_t corner : cube_quads[i])
            text += " " + std::to_string(i < 3 ? int(corner) + 1 : int(corner) - 8);
        text += "\n";
    }
    return text;
}

std::string ply_header_of(const std::string& format, const std::string& index_type) {
    return "ply\nformat " + format +
           " 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\nproperty float "
           "z\nproperty "
           "uchar red\nelement face 6\nproperty list uchar " +
           index_type + " vertex_indices\nend_header\n";
}

std::string cube_ply_ascii() {
    std::string text = ply_header_of("ascii", "int");
    for (std::size_t i = 0; i < cube_corners.size(); i += 3)
        text +=
            text_of(cube_corners[i]) + text_of(cube_corners[i + 1]) + text_of(cube_corners[i + 2]) + "255\n";
    for (const auto& [a, b, c, d] : cube_quads)
        text += "4 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
                std::to_string(d) + "\n";
    return text;
}

template <typename T>
void append(std::string& bytes, T value, bool is_big) {
    std::array<char, sizeof(T)> raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (is_big) std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
}

std::string cube_ply_binary(const char* format) {
    const bool is_big = std::string(format) == "binary_big_endian";
    std::string bytes = ply_header_of(format, "ushort");
    for (std::size_t i = 0; i < cube_corners.size(); i += 3) {
        for (std::size_t axis = 0; axis < 3; ++axis) append(bytes, cube_corners[i + axis], is_big);
        append(bytes, std::uint8_t{255}, is_big);
    }
    for (const auto& quad : cube_quads) {
        append(bytes, std::uint8_t{4}, is_big);
        for (const std::uint32_t corner : quad) append(bytes, std::uint16_t(corner), is_big);
    }
    return bytes;
}

/// What is said of a model that is refused.
std::string refusal_of_model(const TestFolder& folder, const std::string& name, const std::string& content) {
    try {
        load_model_scene(folder.write(name, content));
    } catch (const SceneError& error) {
        return error.what();
    }
    return "loaded";
}

void expect_refusal(const std::string& name, const std::string& content, const std::string& part) {
    const TestFolder folder;
    const std::string refusal = refusal_of_model(folder, name, content);
    EXPECT_NE(refusal.find(name + ": " + part), std::string::npos) << refusal;
}

TEST(ModelFile, ACubeIsTheSameSceneInEveryFormat) {
    const TestFolder folder;
    const std::string expected = sha256_of(load_model_scene(cube_gltf(folder)));
    EXPECT_EQ(sha256_of(load_model_scene(folder.write("cube.obj", cube_obj()))), expected);
    EXPECT_EQ(sha256_of(load_model_scene(folder.write("cube.PLY", cube_ply_ascii()))), expected);
    for (const char* format : {"binary_little_endian", "binary_big_endian"})
        EXPECT_EQ(sha256_of(load_model_scene(folder.write("cube.ply", cube_ply_binary(format)))), expected)
            << format;
}

TEST(ModelFile, FramesWhatBringsNoCamera) {
    const TestFolder folder;
    const Loaded loaded = load_model(folder.write("cube.OBJ", cube_obj()), 320, 200);
    ASSERT_EQ(loaded.views.size(), 1u);
    EXPECT_EQ(loaded.views[0].name, "frame-all");
    EXPECT_EQ(loaded.views[0].width, 320);
    EXPECT_EQ(loaded.scene.name, "cube");
}

TEST(ModelFile, SurvivesFilesThatAreCutOrChanged) {
    const TestFolder folder;
    const std::pair<const char*, std::string> files[] = {{"a.obj", cube_obj()},
                                                         {"a.ply", cube_ply_ascii()},
                                                         {"b.ply", cube_ply_binary("binary_little_endian")},
                                                         {"c.ply", cube_ply_binary("binary_big_endian")}};
    for (const auto& [name, content] : files)
        for (std::size_t i = 0; i < content.size(); ++i) {
            const std::string cut = refusal_of_model(folder, name, content.substr(0, i));
            if (std::string(name) == "b.ply") {
                EXPECT_NE(cut, "loaded") << i;
            }
            for (const int flip : {1, 0x80, 0xFF}) {
                std::string other = content;
                other[i] = char(other[i] ^ flip);
                refusal_of_model(folder, name, other);
            }
        }
}

TEST(Obj, MakesFansInFileOrderWhateverTheGroupsAndMaterials) {
    const TestFolder folder;
    const Scene scene = load_model_scene(folder.write("a.obj",
                                                      "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nusemtl "
                                                      "b\no second\nf 1 2 3 4 5\no first\nusemtl a\nf -1 "
                                                      "-2 -3\nl 1 2\nf 1 2\n"));
    const std::vector<glm::uvec3> expected{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {4, 3, 2}};
    EXPECT_TRUE(std::ranges::equal(scene.triangles, expected));
    ASSERT_EQ(scene.parts.size(), 2u);
    EXPECT_EQ(scene.parts[0].node, "second");
    EXPECT_EQ(scene.parts[1].first_triangle, 3u);
    EXPECT_EQ(scene.parts[1].node_index, 1);
    EXPECT_EQ(scene.notes, (std::vector<std::string>{"unknown materials, white: 2, the first \"b\"",
                                                     "points, lines and curves skipped: 1",
                                                     "faces of fewer than three corners skipped: 1"}));
}

TEST(Obj, GivesEachDifferentCornerAVertex) {
    const TestFolder folder;
    const Scene scene = load_model_scene(folder.write("a.obj", R"(v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
vt 0 0.25
vt 1 0
vn 0 0 2
f 2/1/1 3/2/1 1//1
f 2/1/1 4/1/1 3/1/1
)"));
    EXPECT_TRUE(std::ranges::equal(scene.triangles, std::vector<glm::uvec3>{{0, 1, 2}, {0, 3, 4}}));
    EXPECT_EQ(scene.vertices.position_world[4], glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.vertices.uv[0][0], glm::vec2(0, 0.75f)) << "v is up in OBJ and down here";
    EXPECT_EQ(scene.vertices.normal_world[3], glm::vec3(0, 0, 1));
}

TEST(Obj, ReadsTheBaseColourAndNotesWhatItCannotRead) {
    const TestFolder folder;
    folder.write("a.mtl", "newmtl red\nKd 1 0.5 0\nnewmtl lost\nKd 0 0 1\nmap_Kd no\\such.png\n");
    const Scene scene = load_model_scene(folder.write("a.obj",
                                                      "mtllib a.mtl\nmtllib ../b.mtl\nv 0 0 0\nv 1 0 0\nv 0 "
                                                      "1 0\nusemtl lost\nf 1 2 3\nusemtl red\nf 1 2 3\n"));
    ASSERT_EQ(scene.parts.size(), 2u);
    EXPECT_EQ(scene.materials[std::size_t(scene.parts[1].material)].base_color_factor,
              glm::vec4(1, 0.5f, 0, 1));
    EXPECT_EQ(scene.materials[std::size_t(scene.parts[0].material)].base_color.image, Texture::none);
    ASSERT_EQ(scene.notes.size(), 2u);
    EXPECT_NE(scene.notes[0].find("materials untextured: lost: "), std::string::npos) << scene.notes[0];
    EXPECT_NE(scene.notes[1].find("leaves the file's folder"), std::string::npos) << scene.notes[1];
}

TEST(ModelFile, AByteOrderMarkIsNoPartOfTheFirstWord) {
    const TestFolder folder;
    const std::string mark = "\xEF\xBB\xBF";
    const std::string expected = sha256_of(load_model_scene(folder.write("a.obj", cube_obj())));
    const std::string without_comment = cube_obj().substr(cube_obj().find('\n') + 1);
    for (const std::string& text : {cube_obj(), without_comment})
        EXPECT_EQ(sha256_of(load_model_scene(folder.write("a.obj", mark + text))), expected);
    EXPECT_EQ(sha256_of(load_model_scene(folder.write("a.ply", mark + cube_ply_ascii()))), expected);
    folder.write("a.mtl", mark + "newmtl red\nKd 1 0 0\n");
    const Scene red = load_model_scene(folder.write(
        "b.obj", mark + "mtllib a.mtl\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nusemtl red\r\nf 1 2 3\r\n"));
    EXPECT_EQ(red.materials.back().base_color_factor, glm::vec4(1, 0, 0, 1));
    EXPECT_TRUE(red.notes.empty()) << red.notes[0];
}

TEST(ModelFile, Utf16IsRefusedByName) {
    for (const std::string mark : {"\xFF\xFE", "\xFE\xFF"})
        for (const char* name : {"a.obj", "a.ply", "a.gltf"})
            expect_refusal(name, mark + "v", "byte 0: is UTF-16; expected UTF-8");
}

/// A dart: its fan would reach beyond it.
TEST(ModelFile, ConcaveFacesAreCutInEveryFormat) {
    const TestFolder folder;
    const std::vector<glm::uvec3> expected{{3, 0, 1}, {3, 1, 2}};
    const Scene obj = load_model_scene(
        folder.write("a.obj", "f 1/1 2/1 3/1 4/1\nv 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nvt 0 0\n"));
    EXPECT_TRUE(std::ranges::equal(obj.triangles, expected));
    const Scene ply = load_model_scene(folder.write(
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list int int vertex_index\nend_header\n0 0 0\n2 1 0\n4 "
        "0 0\n2 4 0\n4 0 1 2 3\n"));
    EXPECT_TRUE(std::ranges::equal(ply.triangles, expected));
}

TEST(Obj, NotesLinesAndMaterialsThatItDoesNotKnow) {
    const TestFolder folder;
    const Scene scene = load_model_scene(folder.write(
        "a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\ns off\n\nvx 1\n\x1b[2J\nusemtl \ngroup a\ncall b.obj\nusemtl "
        "red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 1 2 3\n"));
    EXPECT_EQ(scene.notes,
              (std::vector<std::string>{"lines of an unknown keyword skipped: 4, the first \"vx\" in line 6",
                                        "unknown materials, white: 2, the first \"red\""}));
}

TEST(Obj, JoinsLinesThatGoOn) {
    const TestFolder folder;
    const Scene scene = load_model_scene(
        folder.write("a.obj", "v 0 0 0\r\nv 1 0 \\\r\n0\r\nv 0 1 0\r\nf 1 \\\r\n 2 3 # all\r\n"));
    EXPECT_EQ(scene.triangles.size(), 1u);
}

/// A comment and a name may end like a folder.
TEST(Obj, JoinsNoLinesOfCommentsAndNames) {
    const TestFolder folder;
    const Scene scene = load_model_scene(folder.write("a.obj", R"(# from C:\models\
v 0 0 0
v 1 0 0 # left \
v 0 1 0
g C:\a\
f 1 2 3
usemtl a\
f 1 2 3
)"));
    EXPECT_EQ(scene.vertices.position_world.size(), 3u);
    EXPECT_EQ(scene.triangles.size(), 2u);
}

TEST(Obj, TakesNoMemoryForAnIndexThatNoFileOfItsSizeHas) {
    expect_refusal("a.obj", "f 1 2 268435456\n", "line 1: expected an index of a line v");
}

TEST(Obj, NamesTheLineOfWhatIsBroken) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    expect_refusal("a.obj", "v 0 0 0\nv 0 nan 0\n",
                   "line 2: expected a finite number of float32, found \"nan\"");
    expect_refusal("a.obj", "v 0 0 1e39\n", "line 1: expected a finite number of float32, found \"1e39\"");
    expect_refusal("a.obj", "v 0 0\n", "line 1: expected a finite number");
    expect_refusal("a.obj", vertices + "f 1 2 4\nf 1 2 3\n", "line 4: index 4; the file has 3 lines v");
    expect_refusal("a.obj", vertices + "f 1 2 0\n", "line 4: expected an index of a line v");
    expect_refusal("a.obj", vertices + "f 1 2 -4\n", "line 4: expected an index of a line v");
    expect_refusal("a.obj", vertices + "f 1/1 2/1 3/1\n", "line 4: index 1; the file has 0 lines vt");
    expect_refusal("a.obj", vertices + "f 1/1/1/1 2 3\n", "line 4: expected ");
    expect_refusal("a.obj", "", "file: is empty");
}

TEST(Ply, ReadsNormalsUvAndOtherTypes) {
    const TestFolder folder;
    const Scene scene = load_model_scene(folder.write("a.ply", R"(ply
format ascii 1.0
element other 1
property list int float some
element vertex 3
property double x
property double y
property double z
property float nx
property float ny
property float nz
property float s
property float t
element face 1
property uchar flag
property list uchar uint vertex_index
end_header
2 5 6
0 0 0 0 0 2 0 0.25
1 0 0 0 0 2 0 0
0 1 0 nan 0 2 0 0
7 3 0 1 2
)"));
    EXPECT_TRUE(std::ranges::equal(scene.triangles, std::vector<glm::uvec3>{{0, 1, 2}}));
    EXPECT_EQ(scene.vertices.normal_world[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.vertices.normal_world[2], glm::vec3(0));
    EXPECT_EQ(scene.vertices.uv[0][0], glm::vec2(0, 0.75f));
    EXPECT_EQ(scene.notes,
              (std::vector<std::string>{"elements skipped: other",
                                        "vertices whose normal is not finite, read as without one: 1"}));
}

std::string strips_of(const std::string& format, const std::string& index_type) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement tristrips "
           "1\nproperty list int " +
           index_type + " vertex_indices\nend_header\n";
}

TEST(Ply, UnrollsTheStripsOfStanfordsFiles) {
    const TestFolder folder;
    const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 2, 0};
    const std::vector<std::int32_t> corners{-1, 0, 1, 2, 3, -1, 2, 3, 4, 3, -1, 1};
    const std::vector<glm::uvec3> expected{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 3, 4}};
    std::string ascii = strips_of("ascii", "int"), little = strips_of("binary_little_endian", "int"),
                big = strips_of("binary_big_endian", "int");
    for (const float number : positions) {
        ascii += text_of(number);
        append(little, number, false);
        append(big, number, true);
    }
    ascii += "\n12";
    append(little, std::int32_t{12}, false);
    append(big, std::int32_t{12}, true);
    for (const std::int32_t corner : corners) {
        ascii += " " + std::to_string(corner);
        append(little, corner, false);
        append(big, corner, true);
    }
    for (const std::string& text : {ascii, little, big}) {
        const Scene scene = load_model_scene(folder.write("a.ply", text));
        EXPECT_TRUE(std::ranges::equal(scene.triangles, expected));
        EXPECT_EQ(scene.notes, (std::vector<std::string>{"triangles without area, kept: 1"}));
        ASSERT_EQ(scene.parts.size(), 1u);
        EXPECT_EQ(scene.parts[0].triangle_count, 4u);
    }
}

TEST(Ply, HasNoValuesBehindItsElements) {
    const std::string whole = strips_of("ascii", "int") + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n0\n";
    const TestFolder folder;
    EXPECT_TRUE(load_model_scene(folder.write("a.ply", whole + "\n \n")).triangles.empty());
    expect_refusal("a.ply", whole + "3 0 1 2\n", "file: values stand behind the last element");
}

TEST(Ply, NamesTheStripThatIsBroken) {
    const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n";
    const std::string strips = strips_of("ascii", "int") + vertices;
    expect_refusal("a.ply", strips + "3 0 1 5\n", "tristrips 0: expected an index of a vertex from 0 to 4");
    expect_refusal("a.ply", strips + "3 0 1 -2\n", "tristrips 0: expected an index of a vertex from 0 to 4");
    expect_refusal("a.ply", strips + "3 0 1", "tristrips 0: the file ends within it");
    const TestFolder folder;
    EXPECT_TRUE(load_model_scene(folder.write("a.ply", strips + "0\n")).triangles.empty());
}

TEST(Ply, NamesThePlaceOfWhatIsBroken) {
    std::string nan = cube_ply_ascii(), index = nan;
    nan.replace(nan.find("end_header\n") + 11, 2, "nan");
    expect_refusal("a.ply", nan, "vertex 0: x is no finite number of float32");
    index.replace(index.rfind('3'), 1, "8");
    expect_refusal("a.ply", index, "face 5: expected an index of a vertex from 0 to 7");
    expect_refusal("a.ply", "plx\n", "line 1: expected \"ply\"");
    expect_refusal("a.ply", "ply\nformat ascii 2.0\n", "line 2: expected \"format ascii 1.0\"");
    expect_refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex many\n",
                   "line 3: expected a number of elements");
    expect_refusal("a.ply", "ply\nformat ascii 1.0\nproperty float x\n",
                   "line 3: expected \"element NAME COUNT\"");
    expect_refusal("a.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n1\n",
                   "element vertex: 4000000000 elements need at least 2 bytes each");
    expect_refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
                   "element vertex: expected the properties x, y and z");
}

}  // namespace
}  // namespace zproof
