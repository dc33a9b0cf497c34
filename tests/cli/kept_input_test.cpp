// --keep-input keeps what a program was handed, byte for byte.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Copies what it is handed beside the kept files, and draws nothing.
const std::string copier = "cp {scene} seen.glb && cp {camera} seen.json && false {out}";

TEST(KeptInput, IsWhatTheProgramWasHandedAlsoWhereItFails) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    const Ran ran = run(folder, {"run", "one.gltf", "--width", "8", "--height", "6", "--oracle", "none",
                                 "--renderer", copier, "--keep-input", "a/kept"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_EQ(folder.read("a/kept/one.glb"), folder.read("seen.glb"));
    EXPECT_EQ(folder.read("a/kept/one-frame-all.camera.json"), folder.read("seen.json"));
}

TEST(KeptInput, HasANamePerSceneAndView) {
    const Folder folder, kept;
    folder.write("a/one.gltf", one_triangle());
    folder.write("b/one.gltf", two_triangles());
    const Ran ran = run(folder, {"run", "a", "b", "--width", "8", "--height", "6", "--oracle", "none",
                                 "--renderer", "false {out}", "--keep-input", kept.path().string()});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_THAT(kept.names(), ElementsAre("one-2-frame-all.camera.json", "one-2.glb",
                                          "one-frame-all.camera.json", "one.glb"));
    EXPECT_NE(kept.read("one.glb"), kept.read("one-2.glb"));
}

TEST(KeptInput, IsKeptByTheOtherCommandsThatRunPrograms) {
    const Folder folder, checked, measured;
    run(folder, {"contract-check", "false {out}", "--keep-input", checked.path().string()});
    EXPECT_THAT(checked.names(), testing::IsSupersetOf({"room.glb", "room-door.camera.json", "oblique.glb"}));
    run(folder, {"measure", "false {out}", "--keep-input", measured.path().string()});
    EXPECT_THAT(measured.names(), ElementsAre("scene-raster.camera.json", "scene.glb"));
}

TEST(KeptInput, IsRefusedWhereThereIsNoProgramOrNoFolder) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    const Ran no_program = run(folder, {"run", "one.gltf", "--keep-input", "kept"});
    EXPECT_EQ(no_program.exit_code, 2);
    EXPECT_THAT(no_program.err, HasSubstr("--keep-input: only a renderer that is a program"));
    const Ran no_folder = run(folder, {"measure", "false {out}", "--keep-input", "one.gltf/kept"});
    EXPECT_EQ(no_folder.exit_code, 3);
    EXPECT_THAT(no_folder.err, HasSubstr("one.gltf/kept: cannot be made"));
}

}  // namespace
}  // namespace zproof::test
