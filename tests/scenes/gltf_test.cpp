#include "scenes/gltf/gltf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "image_io/image_io.h"
#include "scenes/scene_error.h"
#include "tests/scenes/written_gltf.h"

namespace zproof {
namespace {

using Triangles = Bulk<glm::uvec3>;

const std::vector<float> five_points{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};

bool has_note(const Scene& scene, const std::string& part) {
    for (const std::string& note : scene.notes)
        if (note.find(part) != std::string::npos) return true;
    return false;
}

/// The corners of every triangle of a file of five points in one primitive of the mode.
Triangles triangles_of_mode(int mode) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(five_points);
    gltf.primitive()["mode"] = mode;
    return load_gltf(gltf.write(folder)).scene.triangles;
}

TEST(Gltf, UnrollsAStripWithTheOddTrianglesTurned) {
    EXPECT_EQ(triangles_of_mode(5), (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
}

TEST(Gltf, UnrollsAFanAroundItsFirstVertex) {
    EXPECT_EQ(triangles_of_mode(6), (Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
}

TEST(Gltf, IgnoresTheTailOfATriangleList) { EXPECT_EQ(triangles_of_mode(4), (Triangles{{0, 1, 2}})); }

TEST(Gltf, SkipsPointsAndLines) {
    for (int mode = 0; mode < 4; ++mode) EXPECT_TRUE(triangles_of_mode(mode).empty()) << mode;
}

template <typename T>
Triangles triangles_of_indices(const std::vector<T>& indices, int component_type) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(five_points);
    gltf.primitive()["indices"] = gltf.add_indices(indices, component_type);
    return load_gltf(gltf.write(folder)).scene.triangles;
}

/// The largest index of its type restarts a strip where a graphics card draws it.
TEST(Gltf, HasNoIndexThatRestartsAStrip) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(std::vector<float>(3 * 256));
    gltf.primitive()["indices"] = gltf.add_indices<std::uint8_t>({0, 1, 254, 255}, 5121);
    EXPECT_NE(refusal_of(gltf.write(folder)).find("index 255 at 3; expected indices below 255"),
              std::string::npos);
}

TEST(Gltf, ReadsIndicesOfEveryWidth) {
    const Triangles expected{{4, 3, 2}, {1, 0, 2}};
    EXPECT_EQ(triangles_of_indices<std::uint8_t>({4, 3, 2, 1, 0, 2}, 5121), expected);
    EXPECT_EQ(triangles_of_indices<std::uint16_t>({4, 3, 2, 1, 0, 2}, 5123), expected);
    EXPECT_EQ(triangles_of_indices<std::uint32_t>({4, 3, 2, 1, 0, 2}, 5125), expected);
}

TEST(Gltf, KeepsOnlyTheVerticesInUseWhereAPrimitiveUsesFew) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(five_points);
    gltf.primitive()["indices"] = gltf.add_indices<std::uint8_t>({4, 2, 1}, 5121);
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{1, 0, 0}, {0, 1, 0}, {0, 2, 0}}));
    EXPECT_EQ(scene.triangles, (Triangles{{2, 1, 0}}));
}

TEST(Gltf, RefusesAnIndexAtTheVertexCount) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(five_points);
    gltf.primitive()["indices"] = gltf.add_indices<std::uint16_t>({0, 1, 5}, 5123);
    EXPECT_NE(refusal_of(gltf.write(folder)).find("/accessors/1: index 5 at 2"), std::string::npos);
}

TEST(Gltf, ReadsASparseAccessorOverItsBase) {
    const TestFolder folder;
    WrittenGltf gltf;
    const int position = gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int indices = gltf.add_view<std::uint16_t>({0, 2}),
              values = gltf.add_view<float>({9, 8, 7, 6, 5, 4});
    gltf.json["accessors"][position]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{9, 8, 7}, {1, 0, 0}, {6, 5, 4}}));
}

TEST(Gltf, ReadsASparseAccessorOverZeros) {
    const TestFolder folder;
    WrittenGltf gltf;
    const int indices = gltf.add_view<std::uint8_t>({1}), values = gltf.add_view<float>({3, 2, 1});
    gltf.add_accessor({{"componentType", 5126},
                       {"count", 3},
                       {"type", "VEC3"},
                       {"sparse",
                        {{"count", 1},
                         {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                         {"values", {{"bufferView", values}}}}}});
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{0, 0, 0}, {3, 2, 1}, {0, 0, 0}}));
}

TEST(Gltf, RefusesSparseIndicesThatFall) {
    const TestFolder folder;
    WrittenGltf gltf;
    const int position = gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int indices = gltf.add_view<std::uint16_t>({2, 0}),
              values = gltf.add_view<float>({9, 8, 7, 6, 5, 4});
    gltf.json["accessors"][position]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
        {"values", {{"bufferView", values}}}};
    EXPECT_NE(refusal_of(gltf.write(folder)).find("/accessors/0/sparse/indices: index 0 at 1"),
              std::string::npos);
}

TEST(Gltf, RefusesAHugeSparseAccessorBeforeAllocatingIt) {
    const TestFolder folder;
    WrittenGltf gltf;
    const int indices = gltf.add_view<std::uint8_t>({1}), values = gltf.add_view<float>({3, 2, 1});
    gltf.add_accessor({{"componentType", 5126},
                       {"count", std::uint64_t{1} << 27},
                       {"type", "VEC3"},
                       {"sparse",
                        {{"count", 1},
                         {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                         {"values", {{"bufferView", values}}}}}});
    EXPECT_NE(refusal_of(gltf.write(folder)).find("sparse accessors need more than"), std::string::npos);
}

/// Position, then normal, in one view of 24 byte steps.
TEST(Gltf, ReadsInterleavedAttributes) {
    const TestFolder folder;
    WrittenGltf gltf;
    const int view = gltf.add_view<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0});
    gltf.json["bufferViews"][view]["byteStride"] = 24;
    gltf.add_accessor({{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    gltf.add_accessor(
        {{"bufferView", view}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    gltf.primitive()["attributes"]["NORMAL"] = 1;
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(scene.vertices.normal_world, (Bulk<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

/// Visibility asks for neither.
TEST(Gltf, NotesNormalsAndColoursThatAreNotFinite) {
    const TestFolder folder;
    WrittenGltf gltf;
    const float nan = NAN, infinite = INFINITY;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.primitive()["attributes"]["NORMAL"] = gltf.add_vec3({0, 0, 1, nan, 0, 1, 0, -infinite, 0});
    gltf.primitive()["attributes"]["COLOR_0"] = gltf.add_vec3({1, 0, 0, 0, nan, 0, 0, 0, 1});
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.normal_world, (Bulk<glm::vec3>{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}));
    EXPECT_EQ(scene.vertices.color, (Bulk<glm::vec4>{{1, 0, 0, 1}, {1, 1, 1, 1}, {0, 0, 1, 1}}));
    EXPECT_EQ(scene.notes,
              (std::vector<std::string>{"vertices whose NORMAL is not finite, read as without one: 2",
                                        "vertices whose COLOR_0 is not finite, read as white: 1"}));
}

TEST(Gltf, RefusesPositionsThatAreNotFiniteAlsoWhereNormalsShareThem) {
    const TestFolder folder;
    WrittenGltf gltf;
    const float nan = NAN;
    gltf.add_vec3({0, 0, 0, 1, nan, 0, 0, 1, 0});
    gltf.primitive()["attributes"]["NORMAL"] = 0;
    EXPECT_NE(refusal_of(gltf.write(folder)).find("/accessors/0: element 1 is not finite"),
              std::string::npos);
}

TEST(Gltf, RefusesAnElementThatEndsOneByteBeyondItsView) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.json["bufferViews"][0]["byteLength"] = 35;
    EXPECT_NE(refusal_of(gltf.write(folder))
                  .find("/accessors/0: 3 elements of 12 bytes need 36 bytes at 0, bufferView 0 has 35"),
              std::string::npos);
}

TEST(Gltf, ReadsNormalizedIntegers) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int color = gltf.add_view<std::uint8_t>({255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    gltf.add_accessor({{"bufferView", color},
                       {"componentType", 5121},
                       {"normalized", true},
                       {"count", 3},
                       {"type", "VEC4"}});
    const int uv = gltf.add_view<std::uint16_t>({65535, 0, 13107, 0, 0, 65535});
    gltf.add_accessor(
        {{"bufferView", uv}, {"componentType", 5123}, {"normalized", true}, {"count", 3}, {"type", "VEC2"}});
    gltf.primitive()["attributes"]["COLOR_0"] = 1;
    gltf.primitive()["attributes"]["TEXCOORD_0"] = 2;
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.color.at(0), glm::vec4(1, 0, 0.2f, 0));
    EXPECT_EQ(scene.vertices.uv.at(0), (Bulk<glm::vec2>{{1, 0}, {0.2f, 0}, {0, 1}}));
}

/// -128 and -127 both stand for -1.
TEST(Gltf, ReadsQuantizedPositions) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    gltf.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int view = gltf.add_view<std::int8_t>({-128, 127, 0, 0, -127, 0, 0, 0, 0, 0, 127, 0});
    gltf.json["bufferViews"][view]["byteStride"] = 4;
    gltf.add_accessor({{"bufferView", view},
                       {"componentType", 5120},
                       {"normalized", true},
                       {"count", 3},
                       {"type", "VEC3"}});
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{-1, 1, 0}, {-1, 0, 0}, {0, 0, 1}}));
}

TEST(Gltf, ComposesTransformsInDoubleAndRoundsOnce) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({1, 0, 0, 0, 1, 0, 0, 0, 1});
    // In float32, 2^24 + 1 is lost between the nodes; in double, parent and child cancel exactly.
    gltf.json["nodes"] = {{{"translation", {16777217.0, 0, 0}}, {"children", {1}}},
                          {{"translation", {-16777216.0, 0, 0}}, {"mesh", 0}}};
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{2, 0, 0}, {1, 1, 0}, {1, 0, 1}}));
}

TEST(Gltf, AppliesScaleThenRotationThenTranslation) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({1, 0, 0, 0, 1, 0, 0, 0, 1});
    const double half = std::sqrt(0.5);  // a quarter turn about z: x becomes y
    gltf.json["nodes"][0]["scale"] = {2, 3, 4};
    gltf.json["nodes"][0]["rotation"] = {0, 0, half, half};
    gltf.json["nodes"][0]["translation"] = {10, 20, 30};
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.vertices.position_world, (Positions{{10, 22, 30}, {7, 20, 30}, {10, 20, 34}}));
}

TEST(Gltf, KeepsVertexOrderUnderNegativeScaleAndTurnsNormals) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({1, 0, 0, 0, 1, 0, 0, 0, 1});
    gltf.add_vec3({1, 0, 0, 0, 1, 0, 1, 1, 0});
    gltf.primitive()["attributes"]["NORMAL"] = 1;
    gltf.json["nodes"][0]["scale"] = {-2, 1, 1};
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    EXPECT_EQ(scene.triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(scene.vertices.position_world, (Positions{{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    const glm::vec3 slanted(glm::normalize(glm::dvec3(-0.5, 1, 0)));
    EXPECT_EQ(scene.vertices.normal_world.at(0), glm::vec3(-1, 0, 0));
    EXPECT_EQ(scene.vertices.normal_world.at(1), glm::vec3(0, 1, 0));
    EXPECT_LT(glm::distance(scene.vertices.normal_world.at(2), slanted), 1e-6f);
}

TEST(Gltf, WalksNodesDepthFirstInFileOrder) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.json["scenes"][0]["nodes"] = {3, 0};
    gltf.json["nodes"] = {{{"mesh", 0}, {"name", "d"}},
                          {{"mesh", 0}, {"name", "b"}},
                          {{"mesh", 0}, {"name", "c"}},
                          {{"mesh", 0}, {"name", "a"}, {"children", {1, 2}}}};
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    std::string order;
    for (const Part& part : scene.parts) order += part.node;
    EXPECT_EQ(order, "abcd");
    EXPECT_EQ(scene.triangles, (Triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}}));
}

TEST(Gltf, PadsAttributesThatSomePrimitivesLack) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.add_vec3({0, 0, 2, 0, 0, 2, 0, 0, 2});
    const nlohmann::json plain = {{"attributes", {{"POSITION", 0}}}};
    const nlohmann::json with_normal = {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}};
    gltf.json["meshes"][0]["primitives"] = {plain, with_normal, plain};
    const Scene scene = load_gltf(gltf.write(folder)).scene;
    const glm::vec3 none(0), z(0, 0, 1);
    EXPECT_EQ(scene.vertices.normal_world, (Bulk<glm::vec3>{none, none, none, z, z, z, none, none, none}));
}

/// The arrow of TextureTransformTest: with rotation 22.5 degrees its tip, uv (7/9, 7/9), must show at the
/// green marker.
TEST(Gltf, RotatesTextureCoordinatesAsTheSampleModelAsks) {
    const Loaded loaded = load_gltf(std::filesystem::path(ZPROOF_SHARED) /
                                    "models/TextureTransformTest/TextureTransformTest.gltf");
    const UvTransform& transform = loaded.scene.materials.at(3).base_color.transform;
    const glm::dvec2 marker(0.5 - 0.07904822439840126, 0.5 + 0.5162674857624154);
    const glm::dvec2 tip = transform.linear * marker + transform.translation;
    EXPECT_NEAR(tip.x, 0.5 + 0.2778174593052023, 1e-9);
    EXPECT_NEAR(tip.y, 0.5 + 0.2778174593052023, 1e-9);
}

TEST(Gltf, KeepsWhatRoundingAFactorToFloatCost) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.5, 0.7, 1}}}}});
    const Material material = load_gltf(gltf.write(folder)).scene.materials.at(0);
    const glm::dvec4 read = glm::dvec4{material.base_color_factor} + material.base_color_factor_rounding;
    EXPECT_EQ(read, (glm::dvec4{0.1, 0.5, 0.7, 1}));
    EXPECT_EQ(material.base_color_factor.r, 0.1f);
    EXPECT_NE(material.base_color_factor_rounding.r, 0);
    EXPECT_EQ(material.base_color_factor_rounding.g, 0);
}

/// A triangle whose file uses images of these names, one material each.
WrittenGltf with_images(const std::vector<std::string>& names) {
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (std::size_t i = 0; i < names.size(); ++i) {
        gltf.json["images"].push_back({{"uri", names[i]}});
        gltf.json["textures"].push_back({{"source", i}});
        gltf.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}});
    }
    return gltf;
}

TEST(Gltf, RefusesAnImageInUseWhoseFileIsEmpty) {
    const TestFolder folder;
    folder.write("empty.png", "");
    const std::string refusal = refusal_of(with_images({"empty.png"}).write(folder));
    EXPECT_NE(refusal.find("/images/0: expected a PNG or JPEG image"), std::string::npos) << refusal;
}

TEST(Gltf, NamesTheFirstOfSeveralBrokenImages) {
    const TestFolder folder;
    std::string cut(33, '\0');  // a PNG's signature and header, 1 x 1, and no data
    cut.replace(0, 8, "\x89PNG\r\n\x1A\n");
    cut[19] = cut[23] = 1;
    folder.write("cut.png", cut);
    folder.write("no.png", "no image");
    const std::string refusal = refusal_of(with_images({"cut.png", "cut.png", "no.png"}).write(folder));
    EXPECT_NE(refusal.find("/images/0: the image's data is broken"), std::string::npos) << refusal;
}

/// What the file's refusal says, where libpng says nothing beside it.
std::string refusal_of_png(const std::string& bytes) {
    const TestFolder folder;
    folder.write("a.png", bytes);
    testing::internal::CaptureStderr();
    const std::string refusal = refusal_of(with_images({"a.png"}).write(folder));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    return refusal;
}

TEST(Gltf, RefusesABrokenPngInItsOwnWords) {
    const std::vector<std::byte> whole = encode_png(Plane<Rgb8>({64, 64}, Rgb8{1, 2, 3}));
    const std::string png(reinterpret_cast<const char*>(whole.data()), whole.size());
    for (const std::size_t size : {std::size_t{40}, png.size() / 2, png.size() - 12, png.size() - 1}) {
        const std::string refusal = refusal_of_png(png.substr(0, size));
        EXPECT_NE(refusal.find("/images/0: the image's data is broken or cut short; export it again"),
                  std::string::npos)
            << size << ": " << refusal;
    }
    std::string flipped = png;
    flipped[png.find("IDAT") + 12] ^= 1;
    EXPECT_NE(refusal_of_png(flipped).find("a chunk's sum is wrong"), std::string::npos);
}

TEST(Gltf, NotesSkinsMorphTargetsAndAnimations) {
    const Loaded loaded =
        load_gltf(std::filesystem::path(ZPROOF_SHARED) / "models/AnimationPointer/24_animation_pointer.gltf");
    EXPECT_TRUE(has_note(loaded.scene, "skinned meshes baked at rest"));
    EXPECT_TRUE(has_note(loaded.scene, "animations ignored"));
}

WrittenGltf with_camera(nlohmann::json camera, nlohmann::json node) {
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    node["camera"] = 0;
    gltf.json["cameras"] = nlohmann::json::array({std::move(camera)});
    gltf.json["nodes"].push_back(std::move(node));
    gltf.json["scenes"][0]["nodes"] = {0, 1};
    return gltf;
}

TEST(Gltf, ReadsAnInfinitePerspectiveCamera) {
    const TestFolder folder;
    const double yfov = 2 * std::atan(0.5);
    const WrittenGltf gltf =
        with_camera({{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", 0.25}}}},
                    {{"name", "left eye"}, {"translation", {0.1, 2, 3}}});
    const Loaded loaded = load_gltf(gltf.write(folder), 200, 100);
    ASSERT_EQ(loaded.views.size(), 1u);
    const View& view = loaded.views.front();
    EXPECT_EQ(view.name, "left_eye");
    EXPECT_EQ(view.camera.eye_world, glm::vec3(0.1f, 2, 3));
    EXPECT_EQ(view.camera.far_depth, INFINITY);
    EXPECT_EQ(view.camera.near_depth, 0.25);
    EXPECT_NEAR(view.camera.window.top, 0.5, 1e-15);
    EXPECT_NEAR(view.camera.window.right, 1.0, 1e-15);
    EXPECT_EQ(view.camera.back, glm::dvec3(0, 0, 1));
}

TEST(Gltf, ReadsAnOrthographicCameraAndDropsItsNodesScale) {
    const TestFolder folder;
    const nlohmann::json window = {{"xmag", 4}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}};
    const WrittenGltf gltf = with_camera({{"type", "orthographic"}, {"orthographic", window}},
                                         {{"name", "top"}, {"scale", {2, -2, 2}}});
    const Loaded loaded = load_gltf(gltf.write(folder), 200, 100);
    const Camera& camera = loaded.views.at(0).camera;
    EXPECT_EQ(camera.projection, Projection::parallel);
    EXPECT_EQ(camera.window.right, 4);
    EXPECT_EQ(camera.window.top, 2);
    EXPECT_EQ(glm::dot(glm::cross(camera.right, camera.up), camera.back), 1);
    EXPECT_TRUE(has_note(loaded.scene, "scale and shear of a camera's node dropped"));
    EXPECT_TRUE(has_note(loaded.scene, "mirroring by a camera's node dropped"));
}

TEST(Gltf, GivesEveryCameraANameOfItsOwn) {
    const TestFolder folder;
    WrittenGltf gltf = with_camera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.25}}}},
                                   {{"name", "c"}});
    gltf.json["nodes"].push_back({{"camera", 0}, {"name", "c"}});
    gltf.json["scenes"][0]["nodes"] = {0, 1, 2};
    const Loaded loaded = load_gltf(gltf.write(folder));
    ASSERT_EQ(loaded.views.size(), 2u);
    EXPECT_EQ(loaded.views[0].name, "c");
    EXPECT_EQ(loaded.views[1].name, "c-2");
}

TEST(Gltf, RefusesFilesOutsideItsFolder) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    std::filesystem::create_directories(folder.path() / "inside");
    const std::filesystem::path file = gltf.write(folder);
    std::filesystem::rename(file, folder.path() / "inside/scene.gltf");
    std::filesystem::create_symlink("../scene.bin", folder.path() / "inside/scene.bin");
    EXPECT_NE(refusal_of(folder.path() / "inside/scene.gltf").find("leads out of the file's folder"),
              std::string::npos);
    std::filesystem::remove(folder.path() / "inside/scene.bin");
    std::filesystem::rename(folder.path() / "scene.bin", folder.path() / "inside/scene.bin");
    EXPECT_EQ(refusal_of(folder.path() / "inside/scene.gltf"), "loaded");
}

TEST(Gltf, ReadsFilesWhoseNamesTheUriEscapes) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::filesystem::path file = gltf.write(folder);
    std::filesystem::rename(folder.path() / "scene.bin", folder.path() / "a b+c.bin");
    nlohmann::json whole = gltf.json;
    whole["buffers"] = {{{"uri", "a%20b+c.bin"}, {"byteLength", 36}}};
    EXPECT_EQ(refusal_of(folder.write("scene.gltf", whole.dump())), "loaded");
}

TEST(Gltf, RefusesCoordinatesThatOverflowFloat) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1e20f, 0, 0, 0, 1, 0});
    gltf.json["nodes"][0]["scale"] = {1e20, 1, 1};
    EXPECT_NE(refusal_of(gltf.write(folder)).find("overflows float32"), std::string::npos);
}

TEST(Gltf, NamesTheFirstVertexThatOverflowsAmongManyParts) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3(five_points);
    gltf.json["nodes"] = {
        {{"mesh", 0}}, {{"mesh", 0}, {"scale", {1e39, 1, 1}}}, {{"mesh", 0}, {"scale", {1, 1e39, 1}}}};
    gltf.json["scenes"][0]["nodes"] = {0, 1, 2};
    EXPECT_NE(refusal_of(gltf.write(folder)).find("/nodes/1: vertex 1 overflows"), std::string::npos)
        << refusal_of(gltf.write(folder));
}

TEST(Gltf, RefusesInstancesBeyondTheLimitBeforeAllocatingThem) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    gltf.primitive()["indices"] = gltf.add_indices(std::vector<std::uint8_t>(300'000, 0), 5121);
    gltf.json["nodes"] = nlohmann::json::array();
    gltf.json["scenes"][0]["nodes"] = nlohmann::json::array();
    for (int node = 0; node < 2000; ++node) {
        gltf.json["nodes"].push_back({{"mesh", 0}});
        gltf.json["scenes"][0]["nodes"].push_back(node);
    }
    EXPECT_NE(refusal_of(gltf.write(folder)).find("too large after instancing"), std::string::npos);
}

TEST(Gltf, FramesASceneWithoutCameras) {
    const TestFolder folder;
    WrittenGltf gltf;
    gltf.add_vec3({-3, 5, 7, 2, 5, 9, 1, 6, 8});
    const Loaded loaded = load_gltf(gltf.write(folder), 300, 200);
    ASSERT_EQ(loaded.views.size(), 1u);
    const Camera& camera = loaded.views.front().camera;
    EXPECT_EQ(loaded.views.front().name, "frame-all");
    for (const glm::vec3& position : loaded.scene.vertices.position_world) {
        const glm::dvec3 p = glm::dvec3(position) - glm::dvec3(camera.eye_world);
        const double depth = -glm::dot(p, camera.back);
        EXPECT_GT(depth, camera.near_depth);
        EXPECT_LT(depth, camera.far_depth);
        EXPECT_LT(std::abs(glm::dot(p, camera.right)), camera.window.right * depth);
        EXPECT_LT(std::abs(glm::dot(p, camera.up)), camera.window.top * depth);
    }
}

}  // namespace
}  // namespace zproof
