#include "cli/scene_selection.h"

#include <gtest/gtest.h>

#include "scenes/scene_error.h"
#include "scenes/suite.h"
#include "tests/cli/program.h"

namespace zproof {
namespace {

using test::Folder;
using test::Words;

Words names_of(const std::vector<SceneSource>& sources) {
    Words names;
    for (const SceneSource& source : sources) names.push_back(source.name);
    return names;
}

TEST(SceneSelection, IsTheWholeSuiteWhereNothingIsNamed) {
    const auto manifest = suite_manifest();
    EXPECT_EQ(select_scenes({}).size(), manifest.size());
    EXPECT_EQ(names_of(select_scenes({"suite"})), names_of(select_scenes({})));
    EXPECT_EQ(select_scenes({}).front().reason, manifest.front().reason);
}

TEST(SceneSelection, FindsScenesBelowAFolderInOrder) {
    const Folder folder;
    for (const char* file : {"z.glb", "a/c.gltf", "a/b.view.json", "a/notes.json", "a/b.bin"})
        folder.write(file, "");
    EXPECT_EQ(names_of(select_scenes({folder.path()})), (Words{"b", "c", "z"}));
}

TEST(SceneSelection, LeavesAModelToTheViewFileBesideIt) {
    const Folder folder;
    for (const char* file : {"room.glb", "room.view.json", "other/room.glb"}) folder.write(file, "");
    const auto sources = select_scenes({folder.path()});
    ASSERT_EQ(sources.size(), 2u);
    EXPECT_EQ(sources[0].kind, SceneSource::Kind::gltf);
    EXPECT_EQ(sources[1].kind, SceneSource::Kind::view_file);
}

TEST(SceneSelection, CallsScenesThatShareANameByTheirFiles) {
    const Folder folder;
    for (const char* file : {"a/box.glb", "b/box.glb", "b/ball.glb"}) folder.write(file, "");
    const std::string root = folder.path().string();
    EXPECT_EQ(names_of(select_scenes({root})), (Words{root + "/a/box.glb", "ball", root + "/b/box.glb"}));
}

TEST(SceneSelection, TakesEachSceneOnce) {
    const Folder folder;
    folder.write("a.glb", "");
    const std::string root = folder.path().string();
    EXPECT_EQ(select_scenes({root + "/a.glb", root, root + "/a.glb"}).size(), 1u);
}

TEST(SceneSelection, RefusesAFolderWhereOneSceneIsWanted) {
    const Folder folder;
    EXPECT_THROW(select_scene(folder.path()), SceneError);
    EXPECT_THROW(select_scene("no-such-thing.glb"), SceneError);
    EXPECT_EQ(select_scene(suite_manifest().front().name).origin, "suite");
}

}  // namespace
}  // namespace zproof
