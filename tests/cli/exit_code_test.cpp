// Every row of the table in docs/cli.md, on the real program.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "scenes/suite.h"
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

class ExitCodes : public testing::TestWithParam<Case> {
  protected:
    ExitCodes() {
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
    }
    Folder folder;
};

TEST_P(ExitCodes, AreAsDocumented) {
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
    {"Proven", {"run", "one.gltf"}, 0, "proven"},
    {"Measure", {"measure", "zproof"}, 0, "zproof: as declared"},
    {"MeasureForPrograms", {"measure", "zproof", "--json"}, 0, "\"subpixel_bits_x\""},
    {"MeasureOpenGl", {"measure", "opengl"}, 0, "opengl: as declared"},
    {"HelpOfMeasure", {"measure", "--help"}, 0, "zproof measure zproof"},
    {"PointsAmongTriangles", {"run", "mixed"}, 0, "no triangles"},
    {"NoCommand", {}, 2, "--help"},
    {"UnknownCommand", {"frobnicate"}, 2, "frobnicate"},
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
    {"MeasureNobody", {"measure"}, 2, "RENDERER"},
    {"MeasureUnknown", {"measure", "nosuch"}, 2, "expected one of zproof, embree, opengl, povray"},
    {"MissingFile", {"run", "absent.glb"}, 3, "absent.glb: no such file"},
    {"NotAScene", {"run", "words.txt"}, 3, ".gltf"},
    {"Malformed", {"run", "broken.gltf"}, 3, "broken.gltf"},
    {"MalformedBesideGood", {"run", "one.gltf", "broken.gltf"}, 3, "broken.gltf"},
    {"ExplainMalformed", {"explain", "broken.gltf", "1", "1"}, 3, "broken.gltf"},
    {"ForeignOutputFolder", {"run", "one.gltf", "--out", "foreign"}, 3, "foreign"},
    {"OutputBelowAFile", {"run", "one.gltf", "--out", "file/out"}, 3, "file"},
    {"UnknownSuiteScene", {"scenes", "generate", "no-such-scene"}, 3, "no-such-scene"},
    {"EmptyFolder", {"run", "empty"}, 4, "nothing to judge"},
    {"OnlyPoints", {"run", "clouds"}, 4, "no triangles"},
    {"ExplainPoints", {"explain", "points.gltf", "1", "1"}, 4, "no triangles"},
};

INSTANTIATE_TEST_SUITE_P(Program, ExitCodes, testing::ValuesIn(cases),
                         [](const auto& row) { return std::string{row.param.name}; });

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

TEST(Misspelling, IsAnsweredWithTheSceneThatWasMeant) {
    const Folder folder;
    const std::string name = suite_manifest().front().name;
    const Ran ran = run(folder, {"run", name + "x"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_NE(ran.err.find("did you mean '" + name + "'?"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace zproof::test
