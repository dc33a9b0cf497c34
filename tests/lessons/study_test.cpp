// zproof study as a user types it.
#include <gtest/gtest.h>

#include "reports/pages/folder.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

Words studied(const Words& more) {
    Words words{"study", "projection", "model.gltf", "--width", "64", "--height", "48"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Study, WritesItsFolderAndPrintsItsTables) {
    const Folder folder;
    folder.write("model.gltf", one_triangle());
    const Ran ran = run(folder, studied({"-o", "out", "-j", "1"}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("model / frame-all"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("study: out/study.html"), std::string::npos) << ran.out;
    const document::Document document = document::read_document(folder.path() / "out");
    EXPECT_NE(document.command.find("zproof study projection model.gltf"), std::string::npos);
    EXPECT_FALSE(document.sections.empty());
}

TEST(Study, ItsFolderIsTheSameForAnyNumberOfThreads) {
    const Folder folder;
    folder.write("model.gltf", one_triangle());
    run(folder, studied({"-o", "one", "-j", "1"}));
    run(folder, studied({"-o", "two", "-j", "2"}));
    document::Document one = document::read_document(folder.path() / "one");
    document::Document two = document::read_document(folder.path() / "two");
    one.command = two.command = "";
    EXPECT_EQ(one, two);
}

TEST(Study, EveryStudyTakesAStrangersModel) {
    const Folder folder;
    folder.write("model.gltf", one_triangle());
    for (const char* name : {"depth", "shading"}) {
        const Ran ran =
            run(folder, {"study", name, "model.gltf", "--width", "32", "--height", "24", "-o", name});
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        EXPECT_FALSE(document::read_document(folder.path() / name).sections.empty());
    }
    const Ran ran = run(folder, {"study", "cost", "model.gltf", "--width", "32", "--height", "24",
                                 "--repeats", "1", "-o", "cost"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("k_fragment"), std::string::npos) << ran.out;
}

TEST(Study, PlanesThatAreNoneAreUsageErrors) {
    const Folder folder;
    folder.write("model.gltf", one_triangle());
    EXPECT_EQ(run(folder, {"study", "depth", "model.gltf", "--near", "5", "--far", "2"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"study", "depth", "model.gltf", "--near", "-1"}).exit_code, 2);
}

TEST(Study, WordsThatMeanNothingAreUsageErrors) {
    const Folder folder;
    folder.write("model.gltf", one_triangle());
    EXPECT_EQ(run(folder, {"study"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"study", "projektion"}).exit_code, 2);
    EXPECT_EQ(run(folder, studied({"--view", "nowhere"})).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "zproof-study"));
}

}  // namespace
}  // namespace zproof::test
