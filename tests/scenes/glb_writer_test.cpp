// A scene that is written and loaded again must be the same scene, bit for bit.
#include "scenes/glb_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <limits>

#include "scenes/gltf/gltf.h"
#include "scenes/scene_error.h"
#include "scenes/suite.h"
#include "scenes/view_file.h"
#include "tests/support/test_folder.h"

namespace zproof {
namespace {

Loaded written_and_loaded(const Loaded& loaded) {
    const TestFolder folder;
    write_glb(folder.path(), loaded);
    return load_view_file(folder.path() / (loaded.scene.name + ".view.json"));
}

Scene written_alone_and_loaded(const Scene& scene) {
    const TestFolder folder;
    write_glb_file(folder.path() / "scene.glb", scene);
    return load_gltf_scene(folder.path() / "scene.glb");
}

std::array<std::uint32_t, 3> bits_of_vector(const glm::vec3& v) {
    return std::bit_cast<std::array<std::uint32_t, 3>>(v);
}

void expect_same_bits(const Vertices& a, const Vertices& b) {
    const auto same = [](const glm::vec3& p, const glm::vec3& q) {
        return bits_of_vector(p) == bits_of_vector(q);
    };
    EXPECT_TRUE(std::ranges::equal(a.position_world, b.position_world, same));
    EXPECT_TRUE(std::ranges::equal(a.normal_world, b.normal_world, same));
    EXPECT_EQ(a.uv, b.uv);
    EXPECT_EQ(a.color, b.color);
}

/// Doubles are compared as numbers: no field can be NaN, and -0 means what 0 means.
void expect_same(const View& a, const View& b) {
    SCOPED_TRACE(a.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(bits_of_vector(a.camera.eye_world), bits_of_vector(b.camera.eye_world));
    EXPECT_EQ(a.camera.right, b.camera.right);
    EXPECT_EQ(a.camera.up, b.camera.up);
    EXPECT_EQ(a.camera.back, b.camera.back);
    EXPECT_EQ(a.camera.projection, b.camera.projection);
    const Window &v = a.camera.window, &w = b.camera.window;
    EXPECT_EQ((std::array{v.left, v.right, v.bottom, v.top}), (std::array{w.left, w.right, w.bottom, w.top}));
    EXPECT_EQ(a.camera.shear, b.camera.shear);
    EXPECT_EQ(a.camera.near_depth, b.camera.near_depth);
    EXPECT_EQ(a.camera.far_depth, b.camera.far_depth);
    EXPECT_EQ(a.camera.ndc_depth, b.camera.ndc_depth);
}

void expect_same(const std::vector<View>& a, const std::vector<View>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
}

Positions all_corners(const Scene& scene) {
    Positions corners;
    for (const glm::uvec3& t : scene.triangles)
        for (const int i : {0, 1, 2}) corners.push_back(scene.vertices.position_world[t[i]]);
    return corners;
}

std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

Image gradient() {
    Image image{.name = "gradient", .width = 5, .height = 3, .texels = {}};
    for (int i = 0; i < 4 * 5 * 3; ++i) image.texels.push_back(static_cast<std::uint8_t>(17 * i));
    return image;
}

/// Two triangles in two parts, with every attribute and numbers that decimals cannot hold.
Loaded with_every_attribute() {
    Loaded loaded;
    Scene& scene = loaded.scene;
    scene.name = "every attribute";
    scene.vertices.position_world = {{0.1f, 1.f / 3, -5},      {1e-30f, 0.7f, -6}, {0.3f, 1e6f, -7},
                                     {16'777'217.f, 2, -8.1f}, {3, -4, -9},        {0.2f, 0.3f, -0.1f}};
    scene.vertices.normal_world = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    scene.vertices.uv = {{{0, 0}, {0.1f, 7}, {1, 1}, {-3, 0.2f}, {0.5f, 0.25f}, {1, 0}},
                         {{1, 0}, {0.2f, 8}, {2, 2}, {-4, 0.3f}, {0.75f, 0.5f}, {0, 1}}};
    scene.vertices.color = {{1, 0, 0, 1},          {0, 1, 0, 1}, {0, 0, 1, 0.5f},
                            {0.1f, 0.2f, 0.3f, 1}, {1, 1, 1, 1}, {0, 0, 0, 1}};
    scene.triangles = {{0, 1, 2}, {3, 5, 4}};
    scene.parts = {
        {.node = "a", .mesh = "m", .primitive = 0, .first_triangle = 0, .triangle_count = 1, .material = 1},
        {.node = "b", .mesh = "m", .primitive = 1, .first_triangle = 1, .triangle_count = 1, .material = 0}};
    scene.images = {gradient()};
    Material plain{.name = "plain", .base_color_factor = {0.1f, 0.2f, 0.7f, 1}, .base_color = {}};
    Material textured{.name = "textured", .base_color_factor = {1, 1, 0.3f, 1}, .base_color = {}};
    textured.base_color = {.image = 0,
                           .sampler = {.wrap_u = Wrap::clamp_to_edge,
                                       .wrap_v = Wrap::mirrored_repeat,
                                       .minification = Minification::nearest_mip_linear,
                                       .magnification = Magnification::nearest},
                           .uv_set = 1,
                           .transform = {.linear = glm::dmat2(2.5, 0, 0, -0.125), .translation = {0.1, 0.2}}};
    scene.materials = {plain, textured};
    loaded.views = {View{.name = "only", .camera = {}, .width = 17, .height = 9}};
    return loaded;
}

class EverySuiteSceneWritten : public testing::TestWithParam<std::string> {};

TEST_P(EverySuiteSceneWritten, ComesBackTheSame) {
    const Loaded before = generate_suite_scene(GetParam(), 641, 359);
    const Loaded after = written_and_loaded(before);
    EXPECT_EQ(before.scene.triangles, after.scene.triangles);
    expect_same_bits(before.scene.vertices, after.scene.vertices);
    expect_same(before.views, after.views);
    ASSERT_EQ(before.scene.parts.size(), after.scene.parts.size());
    for (std::size_t p = 0; p < before.scene.parts.size(); ++p) {
        const Part &a = before.scene.parts[p], &b = after.scene.parts[p];
        EXPECT_EQ(a.first_triangle, b.first_triangle);
        EXPECT_EQ(a.triangle_count, b.triangle_count);
        EXPECT_EQ(before.scene.materials.at(static_cast<std::size_t>(a.material)).base_color_factor,
                  after.scene.materials.at(static_cast<std::size_t>(b.material)).base_color_factor);
    }
}

INSTANTIATE_TEST_SUITE_P(Suite, EverySuiteSceneWritten, testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
                             return names;
                         }()),
                         [](const auto& instance) { return instance.param; });

TEST(GlbWriter, KeepsAttributesMaterialsAndImages) {
    const Loaded before = with_every_attribute(), after = written_and_loaded(before);
    EXPECT_EQ(after.scene.name, before.scene.name);
    EXPECT_EQ(after.scene.triangles, before.scene.triangles);
    expect_same_bits(after.scene.vertices, before.scene.vertices);
    ASSERT_EQ(after.scene.images.size(), 1u);
    EXPECT_EQ(after.scene.images[0].width, 5);
    EXPECT_EQ(after.scene.images[0].height, 3);
    EXPECT_EQ(after.scene.images[0].texels, before.scene.images[0].texels);
    ASSERT_EQ(after.scene.parts.size(), 2u);
    const Material& plain = after.scene.materials.at(static_cast<std::size_t>(after.scene.parts[1].material));
    EXPECT_EQ(plain.name, "plain");
    EXPECT_EQ(plain.base_color.image, Texture::none);
}

TEST(GlbWriter, KeepsTheTextureOfAMaterial) {
    const Loaded before = with_every_attribute(), after = written_and_loaded(before);
    const Material& material =
        after.scene.materials.at(static_cast<std::size_t>(after.scene.parts.at(0).material));
    const Texture &a = before.scene.materials[1].base_color, &b = material.base_color;
    EXPECT_EQ(material.name, "textured");
    EXPECT_EQ(material.base_color_factor, before.scene.materials[1].base_color_factor);
    EXPECT_EQ(a.image, b.image);
    EXPECT_EQ(a.uv_set, b.uv_set);
    EXPECT_EQ(a.sampler.wrap_u, b.sampler.wrap_u);
    EXPECT_EQ(a.sampler.wrap_v, b.sampler.wrap_v);
    EXPECT_EQ(a.sampler.minification, b.sampler.minification);
    EXPECT_EQ(a.sampler.magnification, b.sampler.magnification);
    EXPECT_EQ(a.transform.translation, b.transform.translation);
    EXPECT_EQ(a.transform.linear, b.transform.linear);
}

TEST(GlbWriter, KeepsARotatedTextureTransformWithinAFewRoundings) {
    Loaded before = with_every_attribute();
    const double c = 0.8, s = 0.6;  // scale (3, -2), then rotation
    before.scene.materials[1].base_color.transform.linear = glm::dmat2(3 * c, -3 * s, -2 * s, -2 * c);
    const Scene after = written_and_loaded(before).scene;
    const UvTransform& transform =
        after.materials.at(static_cast<std::size_t>(after.parts.at(0).material)).base_color.transform;
    for (const int column : {0, 1})
        for (const int row : {0, 1})
            EXPECT_NEAR(transform.linear[column][row],
                        before.scene.materials[1].base_color.transform.linear[column][row], 1e-14);
}

TEST(GlbWriter, KeepsEveryKindOfCamera) {
    Loaded before = with_every_attribute();
    View perspective{.name = "perspective", .camera = {}, .width = 640, .height = 480};
    perspective.camera.eye_world = {0.1f, 1e6f, -1.f / 3};
    perspective.camera.right = {0.6, 0, -0.8};
    perspective.camera.back = {0.8, 0, 0.6};
    perspective.camera.window = {.left = -0.1, .right = 1.0 / 3, .bottom = 0.01, .top = 0.7};
    perspective.camera.near_depth = 1e-3;
    perspective.camera.far_depth = std::numeric_limits<double>::infinity();
    perspective.camera.ndc_depth = NdcDepth::zero_to_one_reversed;
    View parallel{.name = "parallel", .camera = {}, .width = 1, .height = 2};
    parallel.camera.projection = Projection::parallel;
    parallel.camera.shear = {0.1, -1.0 / 3};
    parallel.camera.near_depth = -7.1;
    parallel.camera.far_depth = 0.3;
    parallel.camera.ndc_depth = NdcDepth::zero_to_one;
    before.views = {perspective, parallel};
    expect_same(before.views, written_and_loaded(before).views);
}

TEST(GlbWriter, KeepsTrianglesOfPartsThatUseTheSameVertices) {
    Loaded before = with_every_attribute();
    before.scene.triangles = {{0, 1, 5}, {3, 5, 4}, {2, 1, 0}};
    before.scene.parts[1].triangle_count = 2;
    EXPECT_EQ(all_corners(before.scene), all_corners(written_and_loaded(before).scene));
}

TEST(GlbWriter, KeepsTrianglesThatAreInNoPart) {
    Scene before = with_every_attribute().scene;
    before.parts.clear();
    before.materials.clear();
    before.images.clear();
    const Scene after = written_alone_and_loaded(before);
    EXPECT_EQ(after.triangles, before.triangles);
    EXPECT_EQ(all_corners(after), all_corners(before));
}

TEST(GlbWriter, WritesASceneWithoutTrianglesWithoutAMesh) {
    Scene scene;
    EXPECT_TRUE(written_alone_and_loaded(scene).triangles.empty());
    scene.vertices.position_world = {{1, 2, 3}};
    const TestFolder folder;
    write_glb_file(folder.path() / "empty.glb", scene);
    const std::string glb = content(folder.path() / "empty.glb");
    EXPECT_EQ(glb.find("meshes"), std::string::npos);
    EXPECT_EQ(glb.find("BIN"), std::string::npos);
}

TEST(GlbWriter, RefusesPartsThatLeaveATriangleOut) {
    const TestFolder folder;
    Loaded loaded = with_every_attribute();
    loaded.scene.parts.pop_back();
    EXPECT_THROW(write_glb(folder.path(), loaded), SceneError);
    loaded = with_every_attribute();
    loaded.scene.parts.erase(loaded.scene.parts.begin());
    EXPECT_THROW(write_glb(folder.path(), loaded), SceneError);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(GlbWriter, WritesOneMeshWhoseChunksFillTheFile) {
    const TestFolder folder;
    write_glb(folder.path(), with_every_attribute());
    const std::string glb = content(folder.path() / "every attribute.glb");
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::copy_n(glb.data() + at, 4, reinterpret_cast<char*>(&value));
        return value;
    };
    ASSERT_GT(glb.size(), 28u);
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2u);
    EXPECT_EQ(word(8), glb.size());
    EXPECT_EQ(glb.substr(16, 4), "JSON");
    const std::size_t binary = 20 + word(12);
    EXPECT_EQ(binary % 4, 0u);
    EXPECT_EQ(glb.substr(binary + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(binary + 8 + word(binary), glb.size());
}

TEST(GlbWriter, ReplacesOldFilesAndLeavesNoOthers) {
    const TestFolder folder;
    std::ofstream(folder.path() / "every attribute.glb") << "old";
    write_glb(folder.path(), with_every_attribute());
    write_glb(folder.path(), with_every_attribute());
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"every attribute.glb", "every attribute.view.json"}));
    EXPECT_NE(content(folder.path() / "every attribute.glb"), "old");
}

TEST(GlbWriter, WritesTheSameBytesEveryTime) {
    const TestFolder folder;
    write_glb(folder.path(), with_every_attribute());
    const std::string once = content(folder.path() / "every attribute.glb");
    write_glb(folder.path(), with_every_attribute());
    EXPECT_EQ(once, content(folder.path() / "every attribute.glb"));
}

TEST(GlbWriter, NamesTheFileThatItCannotWrite) {
    try {
        write_glb("/no/such/folder", with_every_attribute());
        FAIL() << "no exception";
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("/no/such/folder/every attribute.glb"), std::string::npos);
    }
}

TEST(GlbWriter, RefusesNamesThatAreNotFileNames) {
    const TestFolder folder;
    for (const std::string& name :
         {std::string(), std::string("a/b"), std::string(".."), std::string("\xFF")}) {
        Loaded loaded = with_every_attribute();
        loaded.scene.name = name;
        EXPECT_THROW(write_glb(folder.path(), loaded), SceneError) << name;
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(GlbWriter, ReplacesWhatIsNotUtf8InNamesOfMaterials) {
    Loaded before = with_every_attribute();
    before.scene.materials[0].name =
        "a\xFF"
        "b";
    const Scene after = written_and_loaded(before).scene;
    EXPECT_EQ(after.materials.at(static_cast<std::size_t>(after.parts.at(1).material)).name,
              "a\xEF\xBF\xBD"
              "b");
}

TEST(GlbWriter, RefusesAnImageWhoseTexelsDoNotFitItsSize) {
    const TestFolder folder;
    Loaded loaded = with_every_attribute();
    loaded.scene.images[0].width = 4;
    EXPECT_THROW(write_glb(folder.path(), loaded), SceneError);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace zproof
