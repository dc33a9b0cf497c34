// Every row of the table in docs/cli.md, on the real program.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <set>
#include <sstream>

#include "program/command_line/outline.h"
#include "program/exit_code.h"
#include "scenes/suite.h"
#include "tests/cli/outline_of_zproof.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

struct Case {
    const char* name;
    Words arguments;
    int exit_code;
    const char* said;  ///< must occur in what stdout and stderr say
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class ExitCodesOf : public testing::TestWithParam<Case> {
  protected:
    ExitCodesOf() {
        folder.write("one.gltf", one_triangle());
        folder.write("points.gltf", point_cloud());
        folder.write("broken.gltf", R"({"asset": {"version": "2.0"}, "scenes")");
        folder.write("words.txt", "no scene");
        folder.write("empty/readme.txt", "no scene here");
        folder.write("clouds/a.gltf", point_cloud());
        folder.write("mixed/a.gltf", point_cloud());
        folder.write("mixed/b.gltf", one_triangle());
        folder.write("foreign/thesis.tex", "years of work");
        folder.write("file", "not a folder");
        folder.write("model.fbx", "Kaydara FBX Binary");
        folder.write("results/.zproof-out", "");
        folder.write("results/results.json", "{}");
        folder.write("colmap/cameras.txt", "1 PINHOLE 64 48 50 50 32 24\n");
        folder.write("colmap/images.txt", "1 1 0 0 0 0 0 2 1 a.png\n\n");
    }
    Folder folder;
};

TEST_P(ExitCodesOf, AreAsDocumented) {
    Words arguments = GetParam().arguments;
    const Words small{"--width", "64", "--height", "48"};
    if (!arguments.empty() && arguments[0] == "run")
        arguments.insert(arguments.begin() + 1, small.begin(), small.end());
    const Ran ran = run(folder, arguments);
    EXPECT_EQ(ran.exit_code, GetParam().exit_code) << ran.out << ran.err;
    EXPECT_NE((ran.out + ran.err).find(GetParam().said), std::string::npos) << ran.out << ran.err;
    for (const std::string& name : folder.names()) EXPECT_EQ(name.find(".tmp-"), std::string::npos) << name;
}

const std::vector<Case> cases{
    {"Help", {"--help"}, 0, "zproof explain model.glb"},
    {"HelpOfRun", {"run", "--help"}, 0, "--threads"},
    {"Version", {"--version"}, 0, "zproof 0."},
    {"List", {"list"}, 0, "must show"},
    {"ListOfNames", {"list", "--names"}, 0, "\nroom\n"},
    {"Proven", {"run", "one.gltf"}, 0, "proven"},
    {"Measure", {"measure", "zproof"}, 0, "zproof: as declared"},
    {"MeasureForPrograms", {"measure", "zproof", "--json"}, 0, "\"subpixel_bits_x\""},
    {"MeasureEmbree", {"measure", "embree"}, 0, "embree: as declared"},
    {"MeasureOpenGl", {"measure", "opengl"}, 0, "opengl: as declared"},
    {"MeasureVulkan", {"measure", "vulkan"}, 0, "vulkan: as declared"},
    {"Fit", {"fit", "one.gltf", "--width", "64", "--height", "48"}, 0, "explains every pixel"},
    {"FitAWrongView", {"fit", "one.gltf", "--view", "nix"}, 2, "--view nix: "},
    {"FitPoints", {"fit", "points.gltf"}, 4, "no triangles"},
    {"HelpOfMeasure", {"measure", "--help"}, 0, "zproof measure zproof"},
    {"PointsAmongTriangles", {"run", "mixed"}, 0, "no triangles"},
    {"Completion", {"completion", "bash"}, 0, "complete -F _zproof zproof"},
    {"Manual", {"man"}, 0, ".TH ZPROOF 1"},
    {"Doctor", {"doctor", "--config", "none"}, 0, "everything that these settings need is here"},
    {"Generate", {"scenes", "generate", "guard_band"}, 0, "guard_band.view.json"},
    {"Views",
     {"views", "colmap", "colmap", "one.gltf", "--near", "0.1", "-o", "v.view.json"},
     0,
     "1 view; eyes"},
    {"Init", {"init", "-o", "begun"}, 0, "next: cd begun && zproof run"},
    {"InitWithoutALanguage", {"init", "cobol"}, 2, "cobol"},
    {"Render", {"render", "one.gltf", "--width", "8", "--height", "6"}, 0, "frame-all.exr"},
    {"Explain", {"explain", "one.gltf", "1", "1", "--width", "8", "--height", "6"}, 0, "agree"},
    {"FiltersList", {"filters", "list"}, 0, "nearest"},
    {"FiltersCheck",
     {"filters", "check", "nearest", "worked", "--view", "phi-0", "--width", "32", "--height", "32"},
     0,
     "0 not"},
    {"FiltersNormals",
     {"filters", "normals", "--view", "phi-0", "--methods", "nearest", "--width", "16", "--height", "16"},
     0,
     "toksvig"},
    {"FiltersExplain",
     {"filters", "explain", "worked", "--view", "phi-0", "--width", "32", "--height", "32", "--pixel", "9,30",
      "--method", "trilinear-gl"},
     0,
     "pixel 9,30, trilinear-gl: reads level"},
    {"Defect", {"run", "oblique", "--precision", "raster,subpixel_bits=16"}, 1, "defect"},
    {"MeasureABoaster", {"measure", "zproof", "--precision", "raster,subpixel_bits=16"}, 1, "worse"},
    {"NoCommand", {}, 2, "--help"},
    {"UnknownCommand", {"frobnicate"}, 2, "frobnicate"},
    {"MisspelledCommand", {"rnu"}, 2, "did you mean 'run'?"},
    {"MisspelledCommandOfFilters", {"filters", "chekc", "all"}, 2, "did you mean 'check'?"},
    {"MisspelledOption", {"run", "--widht", "64"}, 2, "did you mean '--width'?"},
    {"MisspelledPreset",
     {"run", "one.gltf", "--precision", "opngl"},
     3,
     "subpixel_bits=8; did you mean 'opengl'?"},
    {"OptionOfAnotherCommand",
     {"compare", "a.exr", "one.gltf", "--width", "160", "--height", "120"},
     2,
     "not expected: --width 160 --height 120; --width is an option of 'zproof run'"},
    {"MisspelledOptionWithValue", {"selftest", "--thread=1"}, 2, "did you mean '--threads'?"},
    {"MisspelledRenderer", {"run", "one.gltf", "--renderer", "embre"}, 2, "did you mean 'embree'?"},
    {"MisspelledOracle", {"run", "one.gltf", "--oracle", "povry"}, 2, "did you mean 'povray'?"},
    {"FiltersExplainOutside",
     {"filters", "explain", "worked", "--view", "phi-0", "--width", "32", "--height", "32", "--pixel", "9,32",
      "--method", "nearest"},
     2,
     "--pixel: the view has 32 x 32 pixels, from 0,0; found 9,32"},
    {"FiltersExplainNoPixel",
     {"filters", "explain", "worked", "--view", "phi-0", "--pixel", "9;32", "--method", "nearest"},
     2,
     "--pixel: expected X,Y, found '9;32'"},
    {"MisspelledMethod", {"filters", "run", "worked", "--methods", "neares"}, 2, "did you mean 'nearest'?"},
    {"UnknownShell", {"completion", "csh"}, 2, "csh"},
    {"ViewsWithoutNear", {"views", "colmap", "colmap", "one.gltf", "-o", "v.view.json"}, 2, "--near"},
    {"ScenesWithoutVerb", {"scenes"}, 2, "generate"},
    {"UnknownOption", {"run", "--frobnicate"}, 2, "--frobnicate"},
    {"OptionWithoutValue", {"run", "one.gltf", "--out"}, 2, "--out"},
    {"WidthOfZero", {"render", "one.gltf", "--width", "0"}, 2, "--width"},
    {"UnknownFilter", {"render", "one.gltf", "--filter", "neares"}, 2, "did you mean 'nearest'?"},
    {"Filter", {"render", "one.gltf", "--width", "8", "--height", "6", "--filter", "nearest"}, 0, ".exr"},
    {"ThreadsInWords", {"run", "one.gltf", "--threads", "two"}, 2, "--threads"},
    {"UnknownColour", {"run", "one.gltf", "--color", "mauve"}, 2, "mauve"},
    {"ExplainWithoutPixel", {"explain", "one.gltf"}, 2, "X"},
    {"ExplainOutside", {"explain", "one.gltf", "64", "0", "--width", "64", "--height", "48"}, 2, "64 x 48"},
    {"ExplainUnknownView", {"explain", "one.gltf", "1", "1", "--view", "x"}, 2, "frame-all"},
    {"ConformanceOfNobody", {"conformance"}, 2, "DEVICE"},
    {"ConformanceOfAnUnknown",
     {"conformance", "nosuch"},
     2,
     "expected one of zproof, embree, opengl, povray"},
    {"MeasureNobody", {"measure"}, 2, "RENDERER"},
    {"MeasureUnknown", {"measure", "nosuch"}, 2, "expected one of zproof, embree, opengl, povray"},
    {"VulkanWithoutTheDevice",
     {"run", "one.gltf", "--renderer", "vulkan", "--device", "Voodoo"},
     3,
     "Vulkan: no device 'Voodoo'; expected part of one of: "},
    {"DeviceOfNobody", {"run", "one.gltf", "--device", "Voodoo"}, 2, "--device: is of the renderer vulkan"},
    {"VulkanSetWrongly",
     {"measure", "vulkan:depth=16"},
     2,
     "'depth=16': expected one of depth_format=float32, "},
    {"MissingFile", {"run", "absent.glb"}, 3, "absent.glb: no such file"},
    {"NotAScene", {"run", "words.txt"}, 3, ".gltf"},
    {"ModelOfAnotherKind", {"run", "model.fbx"}, 3, "export any other model as .glb"},
    {"FolderOfResults", {"run", "results"}, 3, "results: holds the results of zproof, not scenes"},
    {"FileOfResults", {"run", "results/results.json"}, 3, "holds the results of zproof, not scenes"},
    {"ExplainResults", {"explain", "results", "1", "1"}, 3, "holds the results of zproof, not scenes"},
    {"Malformed", {"run", "broken.gltf"}, 3, "broken.gltf"},
    {"MalformedBesideGood", {"run", "one.gltf", "broken.gltf"}, 3, "broken.gltf"},
    {"ExplainMalformed", {"explain", "broken.gltf", "1", "1"}, 3, "broken.gltf"},
    {"ForeignOutputFolder", {"run", "one.gltf", "--out", "foreign"}, 3, "foreign"},
    {"OutputBelowAFile", {"run", "one.gltf", "--out", "file/out"}, 3, "file"},
    {"ViewsOfNothing",
     {"views", "nerf", "none.json", "one.gltf", "--near", "0.1", "-o", "v.view.json"},
     3,
     "none.json"},
    {"ViewsBesideTheModel",
     {"views", "colmap", "colmap", "one.gltf", "--near", "0.1", "-o", "colmap/v.view.json"},
     3,
     "stands in its model's folder"},
    {"UnknownSuiteScene", {"scenes", "generate", "nix"}, 3, "nix: no such scene in the suite (zproof list"},
    {"MisspelledSuiteScene", {"scenes", "generate", "guard_band", "rom"}, 3, "did you mean 'room'?"},
    {"UnknownScene", {"run", "nix"}, 3, "nix: no such file, folder or suite scene"},
    {"UnknownSceneOfExplain", {"explain", "nix", "1", "1"}, 3, "nix: no such"},
    {"UnknownSceneOfFilters", {"filters", "run", "workt"}, 3, "did you mean 'worked'?"},
    {"UnknownSceneOfFiltersCheck", {"filters", "check", "nearest", "nix"}, 3, "nix: no such filter scene"},
    {"UnknownSceneOfFiltersExplain",
     {"filters", "explain", "nix", "--view", "a", "--pixel", "1,1", "--method", "nearest"},
     3,
     "nix: no such filter scene"},
    {"UnknownSceneOfAStudy", {"study", "projection", "nix"}, 3, "nix: no such filter scene"},
    {"ReportOfNothing", {"report", "empty", "-o", "a.md"}, 3, "zproof: cannot report: empty"},
    {"DiffOfNothing", {"diff-results", "empty", "empty"}, 3, "zproof: cannot compare the results: empty"},
    {"WaiveListOfNothing",
     {"waive", "list", "--waivers", "absent"},
     3,
     "zproof: cannot list the waivers: absent"},
    {"AbsentSettings", {"run", "--config", "absent"}, 3, "zproof: cannot read the settings: absent"},
    {"CompareMissingFrame", {"compare", "absent.exr", "one.gltf"}, 3, "absent.exr"},
    {"RenderAbsentScene", {"render", "absent.glb"}, 3, "absent.glb"},
    {"ContractCheckOfAMute", {"contract-check", "true {out}"}, 3, "no frame"},
    {"RequiredOracleThatFails", {"run", "one.gltf", "--renderer", "false {out}"}, 3, "exit status 1"},
    {"FiltersNormalsOfNoMap", {"filters", "normals", "nix.png"}, 3, "nix.png"},
    {"FiltersTableOfNothing", {"filters", "table", "empty"}, 3, "empty"},
    {"FiltersRunWithoutTexture", {"filters", "run", "one.gltf", "--methods", "nearest"}, 4, "no pixel"},
    {"EmptyFolder", {"run", "empty"}, 4, "nothing to judge"},
    {"OnlyPoints", {"run", "clouds"}, 4, "no triangles"},
    {"ExplainPoints", {"explain", "points.gltf", "1", "1"}, 4, "no triangles"},
};

INSTANTIATE_TEST_SUITE_P(Program, ExitCodesOf, testing::ValuesIn(cases),
                         [](const auto& row) { return std::string{row.param.name}; });

/// The rows of docs/cli.md (ManualPage's test holds them to exit_statuses()) and those tried here. 70 is a
/// fault of ours, which no command line may provoke; 130 has tests of its own (interrupt_test.cpp).
TEST(ExitCodes, EveryStatusIsTried) {
    std::set<int> tried{int(ExitCode::internal), int(ExitCode::interrupted)};
    for (const Case& c : cases) tried.insert(c.exit_code);
    for (const ExitStatus& status : exit_statuses())
        EXPECT_EQ(tried.count(int(status.code)), 1u) << status.meaning;
}

/// Every command ends well somewhere, and refuses a command line that it cannot understand.
TEST(ExitCodes, EveryCommandRefusesWhatItDoesNotKnow) {
    const Folder folder;
    for (const OutlineCommand& command : leaves_of(outline_of_zproof())) {
        std::istringstream in{command.path};
        Words words;
        for (std::string word; in >> word;) words.push_back(word);
        words.push_back("--frobnicate");
        EXPECT_EQ(run(folder, words).exit_code, 2) << command.path;
    }
}

TEST(ForeignOutputFolder, IsNotTouched) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    folder.write("mine/thesis.tex", "years of work");
    EXPECT_EQ(run(folder, {"run", "one.gltf", "-o", "mine", "--width", "64", "--height", "48"}).exit_code, 3);
    EXPECT_EQ(folder.read("mine/thesis.tex"), "years of work");
    EXPECT_EQ(folder.names(), (Words{"mine", "one.gltf"}));
}

TEST(FullDisk, IsNotMistakenForSuccess) {
    const Folder folder;
    const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
    EXPECT_EQ(exit_code_of(start(folder, {"list"}, {full, full})), 3);
    close(full);
}

TEST(ClosedPipe, ChangesNoVerdict) {
    const Folder folder;
    folder.write("one.gltf", one_triangle());
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    close(ends[0]);
    const int words = open((folder.path() / "words").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    const pid_t id =
        start(folder, {"run", "one.gltf", "--width", "32", "--height", "24", "-q"}, {ends[1], words});
    close(ends[1]);
    EXPECT_EQ(exit_code_of(id), 0);
    close(words);
    EXPECT_EQ(folder.read("words"), "");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "zproof-out/results.json"));
}

TEST(Misspelling, IsAnsweredWithTheSceneThatWasMeant) {
    const Folder folder;
    const std::string name = suite_manifest().front().name;
    const Ran ran = run(folder, {"run", name + "x"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_NE(ran.err.find("did you mean '" + name + "'?"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace zproof::test
