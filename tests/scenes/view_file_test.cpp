#include "scenes/view_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "scenes/scene_error.h"
#include "tests/scenes/written_gltf.h"

namespace zproof {
namespace {

using nlohmann::json;

/// A folder with scene.gltf in it.
class ViewFile : public testing::Test {
  protected:
    ViewFile() {
        WrittenGltf gltf;
        gltf.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
        gltf.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
        gltf.json["nodes"][0]["camera"] = 0;
        gltf.write(folder_);
    }

    Loaded load(const json& content) const {
        return load_view_file(folder_.write("test.view.json", content.dump()));
    }

    Loaded load_one(const json& view) const { return load({{"scene", "scene.gltf"}, {"views", {view}}}); }

    /// What is said after the file's name, or "loaded".
    std::string refusal_of(const json& content) const {
        try {
            load(content);
        } catch (const SceneError& error) {
            const std::string what = error.what(), name = (folder_.path() / "test.view.json").string() + ": ";
            EXPECT_TRUE(what.starts_with(name)) << what;
            return what.substr(std::min(name.size(), what.size()));
        }
        return "loaded";
    }

    std::string refusal_of_view(const json& view) const {
        return refusal_of({{"scene", "scene.gltf"}, {"views", {view}}});
    }

    static json perspective() {
        return {
            {"name", "door"},     {"width", 200},     {"height", 100},       {"projection", "perspective"},
            {"yfov_degrees", 90}, {"eye", {0, 0, 5}}, {"target", {0, 0, 0}}, {"up", {0, 1, 0}},
            {"near", 0.5},        {"far", 100}};
    }

    static json with(const std::string& key, const json& value) {
        json view = perspective();
        view[key] = value;
        return view;
    }

    static json without(const std::string& key) {
        json view = perspective();
        view.erase(key);
        return view;
    }

    TestFolder folder_;
};

TEST_F(ViewFile, ReplacesTheModelsCameras) {
    const Loaded loaded = load_one(perspective());
    ASSERT_EQ(loaded.views.size(), 1u);
    const View& view = loaded.views.front();
    EXPECT_EQ(view.name, "door");
    EXPECT_EQ(view.width, 200);
    EXPECT_EQ(view.height, 100);
    EXPECT_NEAR(view.camera.window.right, 2, 1e-15);
    EXPECT_NEAR(view.camera.window.top, 1, 1e-15);
    EXPECT_EQ(view.camera.back, glm::dvec3(0, 0, 1));
    EXPECT_EQ(view.camera.near_depth, 0.5);
    EXPECT_EQ(view.camera.far_depth, 100);
    EXPECT_EQ(loaded.scene.triangles.size(), 1u);
}

TEST_F(ViewFile, ScalesTheNearWindowToDepthOne) {
    json view = without("yfov_degrees");
    view["near_window"] = {{"left", -0.25}, {"right", 0.5}, {"bottom", -0.125}, {"top", 1}};
    const Window window = load_one(view).views.front().camera.window;
    EXPECT_EQ(window.left, -0.5);
    EXPECT_EQ(window.right, 1);
    EXPECT_EQ(window.bottom, -0.25);
    EXPECT_EQ(window.top, 2);
}

TEST_F(ViewFile, ReadsOrthographicAndObliqueCameras) {
    json view = without("yfov_degrees");
    view["projection"] = "orthographic";
    view["xmag"] = 3;
    view["ymag"] = 2;
    view["near"] = -1;
    const Camera orthographic = load_one(view).views.front().camera;
    EXPECT_EQ(orthographic.projection, Projection::parallel);
    EXPECT_EQ(orthographic.window.left, -3);
    EXPECT_EQ(orthographic.window.top, 2);
    view["projection"] = "oblique";
    view["shear"] = {0.5, -0.25};
    EXPECT_EQ(load_one(view).views.front().camera.shear, glm::dvec2(0.5, -0.25));
    view.erase("shear");
    EXPECT_EQ(refusal_of_view(view), "/views/0: \"shear\" is missing");
}

/// A camera with digits in every place.
Camera odd_camera() {
    Camera camera = look_at({0.1, -7.7, 3.3}, {1.0 / 3, 2.0 / 7, -0.9}, {0.01, 1, 0.02});
    camera.window = {-1.0 / 3, 0.1, -2.0 / 7, 1e-3 / 3};
    camera.near_depth = 1.0 / 3;
    camera.far_depth = std::numeric_limits<double>::infinity();
    camera.ndc_depth = NdcDepth::zero_to_one_reversed;
    return camera;
}

json numbers(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

json exact(const Camera& camera) {
    const Window& w = camera.window;
    return {{"name", "exact"},
            {"projection", "perspective"},
            {"exact_window", {{"left", w.left}, {"right", w.right}, {"bottom", w.bottom}, {"top", w.top}}},
            {"eye", numbers(glm::dvec3(camera.eye_world))},
            {"right", numbers(camera.right)},
            {"up", numbers(camera.up)},
            {"back", numbers(camera.back)},
            {"near", camera.near_depth},
            {"far", "infinity"},
            {"ndc_depth", "zero_to_one_reversed"}};
}

TEST_F(ViewFile, GivesAnExactCameraBackBitForBit) {
    const Camera written = odd_camera();
    const Camera read = load_one(exact(written)).views.front().camera;
    EXPECT_EQ(read.eye_world, written.eye_world);
    EXPECT_EQ(read.right, written.right);
    EXPECT_EQ(read.up, written.up);
    EXPECT_EQ(read.back, written.back);
    EXPECT_EQ(read.window.left, written.window.left);
    EXPECT_EQ(read.window.right, written.window.right);
    EXPECT_EQ(read.window.bottom, written.window.bottom);
    EXPECT_EQ(read.window.top, written.window.top);
    EXPECT_EQ(read.near_depth, written.near_depth);
    EXPECT_EQ(read.far_depth, written.far_depth);
    EXPECT_EQ(read.ndc_depth, written.ndc_depth);
}

TEST_F(ViewFile, SaysWhatWasFoundInPlaceOfWhatWasExpected) {
    EXPECT_EQ(refusal_of_view(with("yfov_degrees", 200)),
              "/views/0/yfov_degrees: expected an angle between 0 and 180 degrees, found 200");
    EXPECT_EQ(refusal_of_view(with("near", "close")), "/views/0/near: expected a number, found \"close\"");
}

TEST_F(ViewFile, NamesUnknownKeysAndWhatIsAllowed) {
    const std::string refusal = refusal_of_view(with("yfov", 1));
    EXPECT_TRUE(refusal.starts_with("/views/0/yfov: unknown key; allowed here: back, ")) << refusal;
    EXPECT_NE(refusal.find("yfov_degrees"), std::string::npos);
    EXPECT_TRUE(refusal_of({{"scene", "scene.gltf"}, {"views", {perspective()}}, {"colour", 1}})
                    .starts_with("/colour: unknown key; allowed here: scene, views"));
}

TEST_F(ViewFile, NamesThePlaceOfEveryFault) {
    EXPECT_EQ(refusal_of_view(without("name")), "/views/0: \"name\" is missing");
    EXPECT_EQ(refusal_of_view(without("near")), "/views/0: \"near\" is missing");
    EXPECT_TRUE(refusal_of_view(with("name", "a/b")).starts_with("/views/0/name: expected 1 to 64"));
    EXPECT_TRUE(refusal_of_view(with("name", "..")).starts_with("/views/0/name: expected 1 to 64"));
    EXPECT_TRUE(refusal_of_view(with("width", 0)).starts_with("/views/0/width: expected an integer"));
    EXPECT_TRUE(refusal_of_view(with("height", 20000)).starts_with("/views/0/height: expected an integer"));
    EXPECT_TRUE(
        refusal_of_view(with("yfov_degrees", 180)).starts_with("/views/0/yfov_degrees: expected an angle"));
    EXPECT_TRUE(
        refusal_of_view(with("projection", "fisheye")).starts_with("/views/0/projection: expected one of"));
    EXPECT_TRUE(refusal_of_view(with("eye", {1, 2})).starts_with("/views/0/eye: expected an array of 3"));
    EXPECT_TRUE(refusal_of_view(with("eye", {1, 2, "x"})).starts_with("/views/0/eye/2: expected a number"));
    EXPECT_TRUE(refusal_of_view(with("far", 0.25)).starts_with("/views/0: camera far"));
    EXPECT_TRUE(refusal_of_view(with("far", "far")).starts_with("/views/0/far: expected a number or"));
    EXPECT_TRUE(
        refusal_of_view(with("ndc_depth", "reversed")).starts_with("/views/0/ndc_depth: expected one of"));
    EXPECT_TRUE(refusal_of_view(with("shear", {0, 0})).starts_with("/views/0/shear: only"));
    EXPECT_TRUE(refusal_of_view(with("xmag", 1)).starts_with("/views/0: expected exactly one of"));
    EXPECT_TRUE(
        refusal_of_view(with("right", {1, 0, 0})).starts_with("/views/0: expected either \"target\""));
    EXPECT_TRUE(refusal_of_view(with("up", {0, 0, 1})).starts_with("/views/0: camera up"));
}

TEST_F(ViewFile, RefusesTwoViewsOfOneNameAndNone) {
    EXPECT_TRUE(refusal_of({{"scene", "scene.gltf"}, {"views", {perspective(), perspective()}}})
                    .starts_with("/views/1/name: expected a name that no other"));
    EXPECT_TRUE(refusal_of({{"scene", "scene.gltf"}, {"views", json::array()}})
                    .starts_with("/views: expected an array"));
    EXPECT_TRUE(refusal_of(json::array()).starts_with("/: expected an object"));
}

TEST_F(ViewFile, KeepsTheSceneInsideItsFolder) {
    for (const char* scene :
         {"../scene.gltf", "/etc/passwd", "file:///etc/passwd", ".", "", "sub/../../x.gltf"})
        EXPECT_TRUE(refusal_of({{"scene", scene}, {"views", {perspective()}}}).starts_with("/scene: "))
            << scene;
}

/// A view file in a folder of its own, beside that of its model.
class ViewFileElsewhere : public ViewFile {
  protected:
    ViewFileElsewhere() {
        std::filesystem::create_directories(folder_.path() / "views");
        std::filesystem::create_directories(models());
        for (const char* name : {"scene.gltf", "scene.bin"})
            std::filesystem::rename(folder_.path() / name, models() / name);
    }

    std::filesystem::path models() const { return folder_.path() / "models"; }

    std::string outcome(const std::string& scene, const std::filesystem::path& root) const {
        const json content{{"scene", scene}, {"views", {perspective()}}};
        try {
            return std::to_string(load_view_file(folder_.write("views/test.view.json", content.dump()), root)
                                      .scene.triangles.size());
        } catch (const SceneError& error) {
            return error.what();
        }
    }
};

TEST_F(ViewFileElsewhere, FindsItsModelBeneathTheFolderOfModels) {
    EXPECT_EQ(outcome("scene.gltf", models()), "1");
    EXPECT_EQ(outcome("../models/scene.gltf", models()), "1");
    EXPECT_EQ(outcome("models/scene.gltf", folder_.path()), "1");
}

TEST_F(ViewFileElsewhere, IsToldOfTheFolderOfModelsWhereNoneIsNamed) {
    for (const char* scene : {"scene.gltf", "../models/scene.gltf"})
        EXPECT_NE(outcome(scene, {}).find("/scene: \"" + std::string{scene} + "\""), std::string::npos);
    EXPECT_NE(outcome("scene.gltf", {}).find("--models DIR"), std::string::npos);
}

TEST_F(ViewFileElsewhere, KeepsForeignFilesOutAllTheSame) {
    folder_.write("scene.gltf", "{}");
    folder_.write("elsewhere.gltf", "{}");
    std::filesystem::create_symlink(folder_.path() / "elsewhere.gltf", models() / "link.gltf");
    for (const std::string scene : {"../scene.gltf", "../../scene.gltf", "link.gltf", "/etc/passwd", ".", "",
                                    "file:///etc/passwd", "absent.gltf"})
        EXPECT_NE(outcome(scene, models()).find(": /scene: "), std::string::npos) << scene;
    EXPECT_NE(outcome("scene.gltf", folder_.path() / "absent").find("is not there"), std::string::npos);
}

TEST_F(ViewFile, RefusesWhatIsNotJson) {
    EXPECT_THROW(load_view_file(folder_.write("test.view.json", "{")), SceneError);
    EXPECT_THROW(load_view_file(folder_.write("test.view.json", std::string(100000, '['))), SceneError);
    EXPECT_THROW(load_view_file(folder_.path() / "absent.view.json"), SceneError);
    EXPECT_THROW(load_view_file(folder_.path()), SceneError);
}

}  // namespace
}  // namespace zproof
