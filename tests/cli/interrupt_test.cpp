#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

/// A pipe that is full: whoever writes to it waits until it is read.
struct FullPipe {
    int read_end = -1, write_end = -1;

    FullPipe() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error{"no pipe"};
        read_end = ends[0];
        write_end = ends[1];
        const int flags = fcntl(write_end, F_GETFL);
        fcntl(write_end, F_SETFL, flags | O_NONBLOCK);
        for (const char fill = '.'; write(write_end, &fill, 1) == 1;) continue;
        fcntl(write_end, F_SETFL, flags);
    }
    ~FullPipe() { close(read_end); }
    FullPipe(const FullPipe&) = delete;
    FullPipe& operator=(const FullPipe&) = delete;

    /// Everything that others wrote; empty, if they were interrupted before they wrote anything.
    std::string drain() {
        close(write_end);
        std::string text;
        std::array<char, 4096> buffer;
        for (ssize_t n; (n = read(read_end, buffer.data(), buffer.size())) > 0;)
            text.append(buffer.data(), std::size_t(n));
        return text.erase(0, text.find_first_not_of('.'));
    }
};

/// Does the process catch SIGINT by now? The kernel says so in /proc/PID/status.
bool catches_interrupts(pid_t pid) {
    std::ifstream status{"/proc/" + std::to_string(pid) + "/status"};
    for (std::string word; status >> word;)
        if (word == "SigCgt:" && status >> word)
            return ((std::stoull(word, nullptr, 16) >> (SIGINT - 1)) & 1) != 0;
    return false;
}

void wait_until_interrupts_are_caught(pid_t pid) {
    while (!catches_interrupts(pid)) std::this_thread::yield();
}

void wait_until_a_second_one_ends_it(pid_t pid) {
    while (catches_interrupts(pid)) std::this_thread::yield();
}

/// What the kernel says of a process in /proc/PID/stat, behind its name: its state first.
Words process_facts(pid_t pid) {
    std::ifstream stat{"/proc/" + std::to_string(pid) + "/stat"};
    stat.ignore(std::numeric_limits<std::streamsize>::max(), ')');
    return {std::istream_iterator<std::string>{stat}, {}};
}

/// Those that a process has started and not yet waited for.
std::vector<pid_t> children_of(pid_t pid) {
    const std::string task = "/proc/" + std::to_string(pid) + "/task/" + std::to_string(pid) + "/children";
    std::ifstream in(task);
    return {std::istream_iterator<pid_t>(in), {}};
}

/// CPU time of the process and of those that it has started, ticks.
long user_ticks_of(pid_t pid) {
    constexpr std::size_t user_ticks = 11;
    const Words facts = process_facts(pid);
    long ticks = facts.size() > user_ticks ? std::stol(facts[user_ticks]) : 0;
    for (const pid_t child : children_of(pid)) ticks += user_ticks_of(child);
    return ticks;
}

/// Waits until the process and its children have worked for so long, or it has ended.
void wait_until_it_worked(pid_t pid, long cpu_s) {
    for (Words facts = process_facts(pid); !facts.empty() && facts.front() != "Z";
         facts = process_facts(pid)) {
        if (user_ticks_of(pid) >= cpu_s * sysconf(_SC_CLK_TCK)) return;
        std::this_thread::yield();
    }
}

/// Where the program is made to wait, so that it is interrupted in the midst of its work.
enum class Blocked { at_its_results, at_its_progress };

/// Interrupts the program while it waits to tell of the first piece of its work. out is kept where err is
/// blocked, and the other way round: what is blocked is read as well.
Ran interrupted_run(const Folder& folder, const Words& arguments, Blocked where, int signal_number = SIGINT) {
    FullPipe pipe;
    const Folder kept;
    const int file = open((kept.path() / "kept").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    const bool blocks_out = where == Blocked::at_its_results;
    const pid_t pid =
        start(folder, arguments, {blocks_out ? pipe.write_end : file, blocks_out ? file : pipe.write_end});
    wait_until_interrupts_are_caught(pid);
    kill(pid, signal_number);
    const std::string drained = pipe.drain();
    close(file);
    const int code = exit_code_of(pid);
    return blocks_out ? Ran{code, drained, kept.read("kept")} : Ran{code, kept.read("kept"), drained};
}

const Words two_scenes{"run", "a.gltf", "b.gltf", "--progress", "lines", "--width", "64", "--height", "48"};

TEST(Interrupt, WritesWhatWasJudgedAndMarksTheRest) {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
        const Folder folder;
        folder.write("a.gltf", one_triangle());
        folder.write("b.gltf", two_triangles());
        const Ran ran = interrupted_run(folder, two_scenes, Blocked::at_its_progress, signal_number);
        EXPECT_EQ(ran.exit_code, 130);
        EXPECT_THAT(ran.err, HasSubstr("finishing the piece in hand"));
        EXPECT_THAT(ran.err, ContainsRegex("interrupted: ([01] of 1 view|no view) judged and written.*; "
                                           "[12] scenes? not begun\n"));
        const auto views = nlohmann::json::parse(folder.read("zproof-out/results.json")).at("views");
        ASSERT_EQ(views.size(), 2u);
        EXPECT_EQ(views[1].at("scene"), "b");
        EXPECT_EQ(views[1].at("outcome"), "not_judged");
        EXPECT_EQ(views[1].at("message"), "interrupted before it was judged");
        EXPECT_EQ(folder.names(), (Words{"a.gltf", "b.gltf", "zproof-out"}));
    }
}

TEST(Interrupt, KeepsTheLastFullReportBesideThePartialOne) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    folder.write("b.gltf", one_triangle());
    ASSERT_EQ(run(folder, two_scenes).exit_code, 0);
    const std::string full = folder.read("zproof-out/results.json");
    const Ran ran = interrupted_run(folder, two_scenes, Blocked::at_its_progress);
    EXPECT_EQ(ran.exit_code, 130);
    EXPECT_THAT(ran.err, HasSubstr("zproof: zproof-out keeps the last full report; this one is in "
                                   "zproof-out.partial\n"));
    EXPECT_EQ(folder.read("zproof-out/results.json"), full);
    const auto partial = nlohmann::json::parse(folder.read("zproof-out.partial/results.json"));
    EXPECT_EQ(partial.at("run").at("ending"), "interrupted");
    EXPECT_EQ(folder.names(), (Words{"a.gltf", "b.gltf", "zproof-out", "zproof-out.partial"}));
}

/// One view's frame is shown for both, and the precision is coarse far from the origin: whoever does not heed
/// the signal judges for minutes.
TEST(Interrupt, EndsAJudgementInTheMidstOfIt) {
    const Folder folder;
    const Words scene{"far_from_origin", "--width", "160", "--height", "90"};
    Words render{"render", "-o", "frames"},
        judge{"run", "--oracle", "none", "--precision", "raster", "--renderer"};
    render.insert(render.end(), scene.begin(), scene.end());
    EXPECT_EQ(run(folder, render).exit_code, 0);
    judge.push_back("cp " + folder.path().string() + "/frames/close.exr {out}");
    judge.insert(judge.end(), scene.begin(), scene.end());
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const pid_t pid = start(folder, judge, {nowhere, nowhere});
    wait_until_it_worked(pid, 4);
    kill(pid, SIGTERM);
    close(nowhere);
    EXPECT_EQ(exit_code_of(pid), 130);
    const auto views = nlohmann::json::parse(folder.read("zproof-out/results.json")).at("views");
    ASSERT_EQ(views.size(), 2u);
    for (const auto& view : views) EXPECT_EQ(view.at("outcome"), "not_judged") << "judged to its end";
}

/// The folders of views in a report that is there or being written.
std::vector<std::string> view_folders(const Folder& folder) {
    std::vector<std::string> found;
    for (const std::string& name : folder.names()) {
        std::error_code absent;
        for (const auto& view : std::filesystem::directory_iterator(folder.path() / name / "scenes", absent))
            found.push_back("scenes/" + view.path().filename().string());
    }
    return found;
}

/// Files are written while the cause is looked for: without the cause, they go as well.
TEST(Interrupt, LeavesNoFilesOfAViewThatIsNotInTheReport) {
    const Folder folder;
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const pid_t pid = start(folder,
                            {"run", "room", "--oracle", "none", "--precision", "raster,subpixel_bits=14",
                             "--width", "480", "--height", "270"},
                            {nowhere, nowhere});
    close(nowhere);
    while (view_folders(folder).empty() && process_facts(pid).front() != "Z") std::this_thread::yield();
    kill(pid, SIGINT);
    EXPECT_EQ(exit_code_of(pid), 130);
    std::vector<std::string> told;
    for (const auto& view : nlohmann::json::parse(folder.read("zproof-out/results.json")).at("views"))
        if (view.at("outcome") != "not_judged") told.push_back(view.at("folder"));
    EXPECT_EQ(view_folders(folder), told);
}

/// A command in the midst of which somebody presses Ctrl-C.
struct Long {
    const char* name;
    Words arguments;
    Blocked where;
    const char*
        said;  ///< what is finished and what is not; the signal comes during the first piece or before
    const char* folder;  ///< is there afterwards; empty: none is
};

void PrintTo(const Long& c, std::ostream* out) { *out << c.name; }

class InterruptOf : public testing::TestWithParam<Long> {
  protected:
    InterruptOf() {
        folder.write("a.gltf", one_triangle());
        const Ran ran = run(folder, {"render", "a.gltf", "--width", "64", "--height", "48", "-o", "frames"});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
    }
    Folder folder;
};

TEST_P(InterruptOf, SaysWhatIsFinished) {
    const Ran ran = interrupted_run(folder, GetParam().arguments, GetParam().where);
    EXPECT_EQ(ran.exit_code, 130) << ran.out << ran.err;
    EXPECT_THAT(ran.err, ContainsRegex(std::string{"zproof: interrupted: "} + GetParam().said));
    Words expected{"a.gltf", "frames"};
    if (*GetParam().folder != '\0') expected.push_back(GetParam().folder);
    EXPECT_THAT(folder.names(), testing::UnorderedElementsAreArray(expected));
}

const std::vector<Long> commands{
    {"Compare",
     {"compare", "frames/frame-all.exr", "a.gltf", "--progress", "bar"},
     Blocked::at_its_progress,
     "(0 of 1 view judged and written, 1 not|no view judged and written; 1 scene not begun)",
     "zproof-out"},
    {"FiltersRun",
     {"filters", "run", "worked", "--view", "phi-0", "--methods", "nearest,bilinear", "--width", "32",
      "--height", "32", "-o", "s"},
     Blocked::at_its_progress,
     "(0 of 2 pictures scored and written, 2 not|no picture scored and written; 1 scene not begun)",
     "s"},
    {"FiltersCheck",
     {"filters", "check", "nearest,bilinear", "worked", "--view", "phi-0", "--width", "32", "--height", "32"},
     Blocked::at_its_results,
     "([01] of 2 pictures judged, [12] not|no picture judged; 1 scene not begun)",
     ""},
    {"FiltersNormals",
     {"filters", "normals", "--view", "phi-0", "--methods", "nearest,bilinear", "--width", "32", "--height",
      "32"},
     Blocked::at_its_results,
     "[01] of 2 filters scored, [12] not",
     ""},
    {"FiltersCrow",
     {"filters", "crow", "--width", "32", "--height", "32"},
     Blocked::at_its_progress,
     "0 of 1 page written, 1 not",
     ""},
    {"Selftest", {"selftest"}, Blocked::at_its_results, "[01] of 75 tests run, 7[45] not", ""},
    {"Measure", {"measure", "zproof"}, Blocked::at_its_progress, "0 of 7 instruments read, 7 not", ""},
    {"Conformance",
     {"conformance", "zproof"},
     Blocked::at_its_progress,
     "([01] of [0-9]+ views? judged and written|no view judged and written)",
     "zproof-conformance"},
    {"ContractCheck",
     {"contract-check", "cp {scene} {out}"},
     Blocked::at_its_results,
     "[01] of 8 pictures asked for and judged, [78] not",
     ""},
    {"ScenesGenerate",
     {"scenes", "generate", "guard_band", "fan_at_pixel_centre", "-o", "s"},
     Blocked::at_its_results,
     "[01] of 2 scenes written, [12] not",
     "s"},
};

INSTANTIATE_TEST_SUITE_P(Program, InterruptOf, testing::ValuesIn(commands),
                         [](const auto& row) { return std::string{row.param.name}; });

/// A FIFO in the folder: a renderer's command waits there until it is opened, or says that it has begun.
void make_fifo(const Folder& folder) { mkfifo((folder.path() / "fifo").c_str(), 0600); }

/// What comes up to and with the end of a line; without one, everything up to the end of the file.
std::string heard_line(int reader) {
    std::string heard;
    for (char c; !heard.ends_with('\n') && read(reader, &c, 1) == 1;) heard += c;
    return heard;
}

TEST(Interrupt, OfRenderLeavesTheViewsThatAreDone) {
    const Folder folder;
    run(folder, {"render", "room", "--width", "64", "--height", "48", "-o", "frames"});
    make_fifo(folder);
    const std::string place = folder.path().string();
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const pid_t pid = start(folder,
                            {"render", "room", "--width", "64", "--height", "48", "-o", "out", "--renderer",
                             "cat " + place + "/fifo; cp " + place + "/frames/door.exr {out}"},
                            {nowhere, nowhere});
    const int gate = open((place + "/fifo").c_str(), O_WRONLY | O_CLOEXEC);  // waits for the renderer
    kill(pid, SIGINT);
    close(gate);
    close(nowhere);
    EXPECT_EQ(exit_code_of(pid), 130);
    EXPECT_FALSE(folder.read("out/door.exr").empty());
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out/floor.exr"));
}

/// Of scenes that were not begun nobody knows how many views they have.
TEST(Interrupt, CountsTheViewsThatAreKnown) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    make_fifo(folder);
    const std::string fifo = folder.path().string() + "/fifo";
    const int out = open((folder.path() / "out").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    const int err = open((folder.path() / "err").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    const pid_t pid = start(folder,
                            {"run", "room", "guard_band", "a.gltf", "--oracle", "none", "--width", "48",
                             "--height", "32", "--renderer", "cat " + fifo + "; : {out}"},
                            {out, err});
    const int gate = open(fifo.c_str(), O_WRONLY | O_CLOEXEC);  // waits for the renderer
    kill(pid, SIGINT);
    close(gate);
    EXPECT_EQ(exit_code_of(pid), 130);
    close(out);
    close(err);
    EXPECT_THAT(folder.read("err"),
                HasSubstr("0 of 2 views judged and written, 2 not; 2 scenes not begun\n"));
    EXPECT_THAT(folder.read("out"), HasSubstr("2 views and 2 whole scenes:"));
    const auto views = nlohmann::json::parse(folder.read("zproof-out/results.json")).at("views");
    ASSERT_EQ(views.size(), 4u);
    EXPECT_EQ(views[0].at("view"), "door");
    EXPECT_EQ(views[1].at("view"), "floor");
    EXPECT_EQ(views[3].at("view"), "");
}

TEST(Interrupt, ASecondOneEndsTheRunAndTheRendererAtOnce) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    make_fifo(folder);
    const std::string fifo = folder.path().string() + "/fifo";
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const pid_t pid = start(folder,
                            {"run", "a.gltf", "--oracle", "none", "--renderer",
                             "exec 3>" + fifo + "; echo begun >&3; sleep 20; echo survived >&3; : {out}"},
                            {nowhere, nowhere});
    const int reader = open(fifo.c_str(), O_RDONLY | O_CLOEXEC);
    EXPECT_EQ(heard_line(reader), "begun\n");
    kill(pid, SIGINT);
    wait_until_a_second_one_ends_it(pid);
    kill(pid, SIGINT);
    close(nowhere);
    EXPECT_EQ(exit_code_of(pid), -1) << "ended by the signal, which a shell reports as 130";
    EXPECT_EQ(heard_line(reader), "") << "the renderer outlived the run";
    close(reader);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "zproof-out"));
}

/// A reader that goes away (zproof run | head) does not end the run before its report is written.
TEST(BrokenPipe, LeavesTheReport) {
    const Folder folder;
    folder.write("a.gltf", one_triangle());
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    close(ends[0]);
    const pid_t pid = start(folder, {"run", "a.gltf", "--oracle", "none", "--width", "64", "--height", "48"},
                            {ends[1], ends[1]});
    close(ends[1]);
    EXPECT_EQ(exit_code_of(pid), 0);
    EXPECT_EQ(folder.names(), (Words{"a.gltf", "zproof-out"}));
}

}  // namespace
}  // namespace zproof::test
