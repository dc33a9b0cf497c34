// --models: view files and models in folders of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::HasSubstr;

/// models/one.gltf, and views/one.view.json that names it.
class Models : public testing::Test {
  protected:
    Models() {
        folder.write("models/one.gltf", one_triangle());
        folder.write("views/one.view.json", R"({"scene": "one.gltf", "views": [{"name": "front", "width": 8,
            "height": 6, "projection": "perspective", "yfov_degrees": 60, "near": 1, "far": 9,
            "eye": [0, 0, 0], "target": [0, 0, -1], "up": [0, 1, 0]}]})");
    }
    Folder folder;
};

TEST_F(Models, AreFoundByEveryCommandThatReadsAViewFile) {
    const std::string view = "views/one.view.json";
    EXPECT_EQ(run(folder, {"run", "views", "--models", "models", "--oracle", "none"}).exit_code, 0);
    EXPECT_EQ(run(folder, {"render", view, "--models", "models", "-o", "drawn"}).exit_code, 0);
    EXPECT_EQ(
        run(folder, {"compare", "drawn/front.exr", view, "--models", "models", "--oracle", "none"}).exit_code,
        0);
    EXPECT_EQ(run(folder, {"explain", view, "4", "3", "--models", "models"}).exit_code, 0);
}

TEST_F(Models, AreNamedInTheCommandsOfFindings) {
    const std::string view = folder.read("views/one.view.json");
    std::string farther = view;
    farther.replace(farther.find("[0, 0, 0]"), 9, "[0, 0, 2]");
    folder.write("views/farther.view.json", farther);
    run(folder, {"render", "views/farther.view.json", "--models", "models", "-o", "drawn"});
    const Ran ran = run(folder, {"compare", "drawn/front.exr", "views/one.view.json", "--models", "models",
                                 "--oracle", "none"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_THAT(folder.read("zproof-out/results.json"), HasSubstr("--models models"));
}

TEST_F(Models, ThatNobodyNamedAreRefusedWithARemedy) {
    const Ran ran = run(folder, {"run", "views", "--oracle", "none"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_THAT(ran.out, HasSubstr("--models DIR"));
    EXPECT_EQ(run(folder, {"run", "views", "--models", "absent"}).exit_code, 2);
}

}  // namespace
}  // namespace zproof::test
