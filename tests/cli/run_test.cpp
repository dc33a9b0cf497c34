// What zproof run leaves behind, on the real program.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "scenes/suite.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;

const Words small{"--width", "96", "--height", "64"};

Words run_words(Words words) {
    words.insert(words.begin(), "run");
    words.insert(words.end(), small.begin(), small.end());
    return words;
}

/// results.json without what may differ between two runs of the same input.
json comparable(const Folder& folder, const std::string& out) {
    json results = json::parse(folder.read(out + "/results.json"));
    results.erase("run");
    for (json& view : results.at("views")) view.erase("times");
    return results;
}

TEST(Run, LeavesTheReportsAndTheEvidenceOfASuiteScene) {
    const Folder folder;
    const std::string name = suite_manifest().front().name;
    const Ran ran = run(folder, run_words({name, "--evidence", "all"}));
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(folder.names(), Words{"zproof-out"});
    const json results = json::parse(folder.read("zproof-out/results.json"));
    for (const json& view : results.at("views")) {
        EXPECT_EQ(view.at("scene"), name);
        EXPECT_GT(folder.read("zproof-out/" + view.at("folder").get<std::string>() + "/candidate.exr").size(),
                  0u);
    }
    EXPECT_NE(folder.read("zproof-out/junit.xml").find(name), std::string::npos);
    EXPECT_NE(folder.read("zproof-out/report.html").find(name), std::string::npos);
}

TEST(Run, SaysTheSameForAnyNumberOfThreads) {
    const Folder folder;
    const auto manifest = suite_manifest();
    for (const char* threads : {"1", "2", "5"})
        ASSERT_EQ(run(folder, run_words({manifest[0].name, manifest[1].name, "--evidence", "all", "--threads",
                                         threads, "-o", threads}))
                      .exit_code,
                  0);
    EXPECT_EQ(comparable(folder, "1"), comparable(folder, "2"));
    EXPECT_EQ(comparable(folder, "1"), comparable(folder, "5"));
}

/// A promise that it does not keep makes views fail.
TEST(Run, TellsOneCauseOfAllViewsOrSeeksNone) {
    const Folder folder;
    const Words words{"room", "--oracle", "none", "--precision", "raster,subpixel_bits=12"};
    EXPECT_EQ(run(folder, run_words(words)).exit_code, 1);
    const json sought = json::parse(folder.read("zproof-out/results.json"));
    EXPECT_EQ(sought.at("/causes/0/name"_json_pointer), "only 8 sub-pixel bits");
    EXPECT_EQ(sought.at("/causes/0/views"_json_pointer), sought.at("/summary/defective"_json_pointer));
    EXPECT_NE(folder.read("zproof-out/junit.xml").find("only 8 sub-pixel bits. Look at"), std::string::npos);
    Words without = words;
    without.push_back("--no-diagnosis");
    const Ran ran = run(folder, run_words(without));
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_NE(ran.out.find("\nNo cause was sought (--no-diagnosis).\n"), std::string::npos) << ran.out;
    const json left_out = json::parse(folder.read("zproof-out/results.json"));
    EXPECT_EQ(left_out.at("/causes"_json_pointer), json::array());
    for (const json& view : left_out.at("views")) EXPECT_EQ(view.at("diagnosis"), nullptr);
}

TEST(Run, GoesOnPastAnUnreadableScene) {
    const Folder folder;
    folder.write("models/a.gltf", "{");
    folder.write("models/b.gltf", two_triangles());
    EXPECT_EQ(run(folder, run_words({"models"})).exit_code, 3);
    const json views = json::parse(folder.read("zproof-out/results.json")).at("views");
    ASSERT_EQ(views.size(), 2u);
    EXPECT_EQ(views[0].at("outcome"), "unreadable");
    EXPECT_EQ(views[1].at("outcome"), "proven");
}

TEST(Run, ReplacesItsOwnOutput) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    folder.write("b.gltf", two_triangles());
    EXPECT_EQ(run(folder, run_words({"a.gltf"})).exit_code, 0);
    EXPECT_EQ(run(folder, run_words({"b.gltf"})).exit_code, 0);
    EXPECT_EQ(json::parse(folder.read("zproof-out/results.json")).at("views")[0].at("scene"), "b");
    EXPECT_EQ(folder.names(), (Words{"a.gltf", "b.gltf", "zproof-out"}));
}

TEST(Run, TellsResultsOnStdoutAndProgressOnStderr) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    const Ran loud = run(folder, run_words({"a.gltf"}));
    EXPECT_EQ(loud.err.find("[1/1] proven"), 0u) << loud.err;
    EXPECT_EQ(loud.out.find("[1/1]"), std::string::npos) << loud.out;
    const Ran quiet = run(folder, run_words({"a.gltf", "-q"}));
    EXPECT_EQ(quiet.err, "");
    EXPECT_EQ(quiet.out, "proven: 1 view; report: zproof-out/report.html\n");
}

TEST(Run, DoesNotCallProvenWhatWasNotJudged) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    folder.write("b.gltf",
                 R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{}]})");
    const Ran ran = run(folder, run_words({"a.gltf", "b.gltf", "-q"}));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.out, "proven: 1 view; 1 whole scene not judged; report: zproof-out/report.html\n");
}

/// The renderer reads what the run has told until it is asked for the scene's second view.
TEST(Run, TellsAViewWhenItIsJudged) {
    const Folder folder;
    ASSERT_EQ(run(folder, {"render", "room", "--width", "48", "--height", "32", "-o", "frames"}).exit_code,
              0);
    const std::string place = folder.path().string();
    const int told = open((place + "/told").c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600);
    const pid_t pid = start(
        folder,
        {"run", "room", "--width", "48", "--height", "32", "--oracle", "none", "--progress", "lines",
         "--renderer", "cp " + place + "/told " + place + "/seen; cp " + place + "/frames/door.exr {out}"},
        {told, told});
    exit_code_of(pid);
    close(told);
    EXPECT_EQ(folder.read("seen").find("[1/1] proven      room / door"), 0u) << folder.read("seen");
}

/// A renderer that fails, or is killed, has taken its time.
TEST(Run, CountsTheTimeOfAViewThatDidNotCome) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    EXPECT_EQ(
        run(folder, run_words({"a.gltf", "--renderer", "sleep 5; : {out}", "--time-limit", "1"})).exit_code,
        3);
    const json view = json::parse(folder.read("zproof-out/results.json")).at("views").at(0);
    EXPECT_EQ(view.at("outcome"), "unreadable");
    EXPECT_GE(view.at("times").at("render"), 0.9);
}

/// A program is not installed where PATH does not lead to it.
TEST(Run, SaysHowToInstallWhatIsNotInstalled) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    const Words nothing_installed{"PATH=/nowhere"};
    const std::string remedy = "not installed; on Debian: apt-get install povray";
    const Ran unasked = run(folder, run_words({"a.gltf"}), nothing_installed);
    EXPECT_EQ(unasked.exit_code, 0) << unasked.out << unasked.err;
    const std::size_t said = unasked.out.find("povray: not compared in 1 view: " + remedy);
    EXPECT_NE(said, std::string::npos) << unasked.out;
    EXPECT_EQ(unasked.out.find("povray", said + remedy.size() + 40), std::string::npos) << "said once";
    for (const char* option : {"--oracle", "--require", "--renderer"}) {
        const Ran named = run(folder, run_words({"a.gltf", option, "povray"}), nothing_installed);
        EXPECT_EQ(named.exit_code, 3) << option << named.out;
        EXPECT_EQ(named.err, "zproof: cannot judge: povray: " + remedy + "\n") << option;
    }
}

TEST(Run, ColoursATerminalUnlessAskedNotTo) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    const auto coloured = [&](const Words& more, const Words& environment) {
        Words words = run_words({"a.gltf", "--progress", "none"});
        words.insert(words.end(), more.begin(), more.end());
        return run_on_terminal(folder, words, environment).out.find('\x1b') != std::string::npos;
    };
    EXPECT_TRUE(coloured({}, {"TERM=xterm", "NO_COLOR="}));
    EXPECT_FALSE(coloured({}, {"TERM=xterm", "NO_COLOR=1"}));
    EXPECT_FALSE(coloured({}, {"TERM=dumb", "NO_COLOR="}));
    EXPECT_FALSE(coloured({"--color", "never"}, {"TERM=xterm", "NO_COLOR="}));
    EXPECT_TRUE(coloured({"--color", "always"}, {"TERM=dumb", "NO_COLOR=1"}));
}

TEST(Run, NamesTheCommandThatExplainsAPixelAndThatCommandWorks) {
    const Folder folder;
    folder.write("it's.gltf", one_triangle());
    const Ran ran = run(folder, {"explain", "it's.gltf", "48", "32", "--width", "96", "--height", "64"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out, "");
}

TEST(Scenes, GeneratedAsFilesAreJudgedLikeTheSuite) {
    const Folder folder;
    const std::string name = suite_manifest().front().name;
    ASSERT_EQ(run(folder, {"scenes", "generate", name, "-o", "scenes"}).exit_code, 0);
    ASSERT_EQ(run(folder, {"run", "scenes", "-o", "of-files"}).exit_code, 0);
    ASSERT_EQ(run(folder, {"run", name, "-o", "of-suite"}).exit_code, 0);
    const json of_files = comparable(folder, "of-files").at("views"),
               of_suite = comparable(folder, "of-suite").at("views");
    ASSERT_EQ(of_files.size(), of_suite.size());
    for (std::size_t i = 0; i < of_files.size(); ++i)
        EXPECT_EQ(of_files[i].at("counts"), of_suite[i].at("counts"));
}

}  // namespace
}  // namespace zproof::test
