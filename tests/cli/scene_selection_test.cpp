#include "program/scene_selection.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "scenes/scene_error.h"
#include "scenes/suite.h"
#include "tests/cli/program.h"
#include "tests/frame/scratch_folder.h"

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

TEST(SceneSelection, CountsWhatItPassesOverInFolders) {
    const Folder folder;
    for (const char* file :
         {"z.glb", "a/b.view.json", "a/b.glb", "a/notes.json", "a/b.PNG", "c.png", "Makefile"})
        folder.write(file, "");
    const SceneSelection selection = select_with_counts({folder.path()});
    EXPECT_EQ(names_of(selection.sources), (Words{"b", "z"}));
    EXPECT_EQ(in_words(selection.passed_over), "4 files passed over: 2 .png, 1 without an ending, 1 .json");
    EXPECT_EQ(in_words(select_with_counts({"room"}).passed_over), "");
    EXPECT_EQ(in_words({{".png", 9}, {".txt", 3}}), "12 files passed over: 9 .png, 3 .txt");
    EXPECT_EQ(in_words({{".a", 1}, {".b", 1}, {".c", 1}, {".d", 1}, {".e", 1}, {".f", 1}, {".g", 2000}}),
              "2,006 files passed over: 2,000 .g, 1 .a, 1 .b, 1 .c, 1 .d, 1 .e, ...");
}

TEST(SceneSelection, LooksIntoNothingThatARunWrote) {
    const Folder folder;
    for (const char* file : {"room.glb", ".zproof-out", "out/.zproof-out", "out/results.json",
                             "out/shrunk/a.view.json", "generated/.zproof-out", "generated/b.view.json"})
        folder.write(file, "");
    const SceneSelection selection = select_with_counts({folder.path()});
    EXPECT_EQ(names_of(selection.sources), (Words{"b", "room"}));
    EXPECT_EQ(in_words(selection.passed_over), "");
}

TEST(SceneSelection, TellsWhatARunPassedOverOnceUnlessQuiet) {
    const Folder folder;
    folder.write("one.gltf", test::one_triangle());
    folder.write("notes.txt", "");
    Words words{"run", ".", "--oracle", "none", "--width", "64", "--height", "48"};
    EXPECT_NE(test::run(folder, words).err.find("zproof: 1 file passed over: 1 .txt\n"), std::string::npos);
    words.emplace_back("-q");
    EXPECT_EQ(test::run(folder, words).err, "");
}

TEST(SceneSelection, LeavesAModelToTheViewFileBesideIt) {
    const Folder folder;
    for (const char* file : {"room.glb", "room.view.json", "other/room.glb"}) folder.write(file, "");
    const auto sources = select_scenes({folder.path()});
    ASSERT_EQ(sources.size(), 2u);
    EXPECT_EQ(sources[0].kind, SceneSource::Kind::model);
    EXPECT_EQ(sources[1].kind, SceneSource::Kind::view_file);
}

TEST(SceneSelection, CallsScenesThatShareANameByTheirFiles) {
    const Folder folder;
    for (const char* file : {"a/box.glb", "b/box.glb", "b/ball.glb"}) folder.write(file, "");
    const std::string root = folder.path().string();
    EXPECT_EQ(names_of(select_scenes({root})), (Words{root + "/a/box.glb", "ball", root + "/b/box.glb"}));
}

TEST(SceneSelection, TakesEndingsOfAnyCase) {
    const Folder folder;
    for (const char* file : {"A.GLB", "b.GlTf", "C.View.JSON", "D.JSON", "e.Obj", "f.PLY", "g.mtl"})
        folder.write(file, "");
    EXPECT_EQ(names_of(select_scenes({folder.path()})), (Words{"A", "C", "b", "e", "f"}));
    EXPECT_EQ(select_scene((folder.path() / "A.GLB").string()).kind, SceneSource::Kind::model);
}

TEST(SceneSelection, NamesWhatCannotBeLookedAtBesideTheRest) {
    const Folder folder;
    folder.write("good.gltf", test::one_triangle());
    std::filesystem::create_symlink("b.gltf", folder.path() / "a.gltf");
    std::filesystem::create_symlink("a.gltf", folder.path() / "b.gltf");
    const auto sources = select_scenes({folder.path()});
    EXPECT_EQ(names_of(sources), (Words{"a", "b", "good"}));
    EXPECT_THROW(load(sources.at(0), {8, 6}), SceneError);
    EXPECT_NO_THROW(load(sources.at(2), {8, 6}));
    const test::Ran ran =
        test::run(folder, {"run", ".", "--oracle", "none", "--width", "64", "--height", "48"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_NE(ran.err.find("good"), std::string::npos) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("a.gltf: file: is a loop of links"), std::string::npos) << ran.out << ran.err;
}

/// A folder that this process may not list: what root may not do is tried as somebody else.
TEST(SceneSelection, NamesAFolderThatCannotBeRead) {
    const Folder folder;
    folder.write("good.gltf", "");
    folder.write("closed/hidden.gltf", "");
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    std::filesystem::permissions(folder.path() / "closed", std::filesystem::perms(0));
    const uid_t before = geteuid();
    ASSERT_EQ(seteuid(before == 0 ? 65534 : before), 0);
    const auto sources = select_scenes({folder.path()});
    std::string said;
    try {
        load(sources.at(0), {8, 6});
    } catch (const SceneError& e) {
        said = e.what();
    }
    ASSERT_EQ(seteuid(before), 0);
    std::filesystem::permissions(folder.path() / "closed", std::filesystem::perms(0755));
    EXPECT_EQ(names_of(sources), (Words{"closed", "good"}));
    EXPECT_NE(said.find("closed: folder cannot be read"), std::string::npos) << said;
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

TEST(SceneSelection, SaysThatAFolderOfScenesIsOneThoughZproofWroteThem) {
    const Folder folder;
    folder.write(".zproof-out", "");
    folder.write("a.glb", "");
    EXPECT_EQ(complaint<SceneError>([&] { select_scene(folder.path()); }),
              folder.path().string() + ": a folder, where one scene was expected; name a file in it");
}

}  // namespace
}  // namespace zproof
