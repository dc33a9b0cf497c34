// --isa and ZPROOF_ISA: the instruction set makes no difference, on the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "math/processor.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

namespace fs = std::filesystem;

/// The evidence, file by file, and results.json without `run` and times.
using Files = std::map<std::string, std::string>;

Files files_of(const Folder& folder) {
    const fs::path out = folder.path() / "zproof-out";
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(out / "scenes"))
        if (entry.is_regular_file()) {
            const fs::path name = fs::relative(entry.path(), folder.path());
            files[name.string()] = folder.read(name);
        }
    json results = json::parse(folder.read("zproof-out/results.json"));
    results.erase("run");
    for (json& view : results.at("views")) view.erase("times");
    files["results.json"] = results.dump();
    return files;
}

std::string isa_in_results(const Folder& folder) {
    return json::parse(folder.read("zproof-out/results.json")).at("run").at("isa");
}

std::string widest_here() { return std::string(name_of(instruction_sets().back())); }

const Words one_triangle_small{"run",      "one.gltf", "--width",  "16",   "--height", "16",
                               "--oracle", "none",     "--config", "none", "-q"};

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Isa, EveryInstructionSetWritesTheSameFiles) {
    std::map<std::string, Files> files;
    for (const InstructionSet set : instruction_sets()) {
        const Folder folder;
        const std::string name(name_of(set));
        const Ran ran = run(folder, {"run", "near_plane", "deep_overdraw", "room", "--width", "160",
                                     "--height", "90", "--evidence", "all", "--pictures", "--oracle", "none",
                                     "--config", "none", "--isa", name});
        ASSERT_EQ(ran.exit_code, 0) << ran.out << ran.err;
        EXPECT_EQ(isa_in_results(folder), name);
        files[name] = files_of(folder);
    }
    const Files& scalar = files.at("scalar");
    EXPECT_GT(scalar.size(), 20u);
    for (const auto& [name, of_set] : files) {
        ASSERT_EQ(of_set.size(), scalar.size()) << name;
        for (const auto& [file, content] : scalar)
            EXPECT_TRUE(of_set.contains(file) && of_set.at(file) == content) << name << ": " << file;
    }
}

TEST(Isa, IsTheProcessorsWidestUnlessTheOptionOrElseTheEnvironmentSaysLess) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    ASSERT_EQ(run(folder, one_triangle_small).exit_code, 0);
    EXPECT_EQ(isa_in_results(folder), widest_here());
    ASSERT_EQ(run(folder, one_triangle_small, {"ZPROOF_ISA=scalar"}).exit_code, 0);
    EXPECT_EQ(isa_in_results(folder), "scalar");
    ASSERT_EQ(
        run(folder, with(one_triangle_small, {"--isa", widest_here()}), {"ZPROOF_ISA=scalar"}).exit_code, 0);
    EXPECT_EQ(isa_in_results(folder), widest_here());
}

TEST(Isa, IsASettingLikeOthers) {
    const Folder folder;
    folder.write("zproof.toml", "isa = \"scalar\"\n");
    EXPECT_THAT(run(folder, {"doctor"}).out,
                AllOf(HasSubstr("(scalar is used)"), HasSubstr("zproof.toml:1")));
    EXPECT_THAT(run(folder, {"doctor", "--config", "none"}).out,
                HasSubstr("(" + widest_here() + " is used)"));
}

TEST(Isa, ThatIsUnknownOrNotHereIsAUsageError) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    const auto says_what_is_here = AllOf(HasSubstr("scalar"), HasSubstr(widest_here()));
    const Ran typed = run(folder, with(one_triangle_small, {"--isa", "sse2"}));
    EXPECT_EQ(typed.exit_code, 2);
    EXPECT_THAT(typed.err, AllOf(HasSubstr("--isa"), HasSubstr("'sse2'"), says_what_is_here));
    const Ran said = run(folder, one_triangle_small, {"ZPROOF_ISA=sse2"});
    EXPECT_EQ(said.exit_code, 2);
    EXPECT_THAT(said.err, AllOf(HasSubstr("ZPROOF_ISA"), HasSubstr("'sse2'"), says_what_is_here));
    if (widest_here() == "avx512") return;
    const Ran absent = run(folder, with(one_triangle_small, {"--isa", "avx512"}));
    EXPECT_EQ(absent.exit_code, 2);
    EXPECT_THAT(absent.err, AllOf(HasSubstr("this processor has no avx512"), says_what_is_here));
}

/// `scenes generate` has no --isa, and its terrain has loops that ask for one.
TEST(Isa, InTheEnvironmentIsHeldAgainstTheProcessorByEveryCommandThatAsks) {
    const Folder folder;
    const Ran ran = run(folder, {"scenes", "generate", "million_triangles"}, {"ZPROOF_ISA=sse2"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("ZPROOF_ISA: expected one of scalar"));
}

}  // namespace
}  // namespace zproof::test
