// Plans: every view once, shards of about one length, and merged results that are one run's.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "cli/plan/assignment.h"
#include "cli/plan/expected_seconds.h"
#include "reports/plan.h"
#include "reports/report_error.h"
#include "tests/cli/program.h"
#include "tests/cli/same_run.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

// ---- who judges what

/// Scenes at random: few of them long, as in life.
Plan plan_at_random(std::uint32_t seed, int shards) {
    std::mt19937 random(seed);
    const auto up_to = [&](int most) { return int(random() % std::uint32_t(most)); };
    Plan plan{.version = "1", .commit = "c", .shards = shards, .runs = {{}, {}}};
    for (PlannedRun& run : plan.runs)
        for (int s = 0; s < 1 + up_to(12); ++s) {
            PlannedScene& scene = run.scenes.emplace_back();
            scene.scene = "s" + std::to_string(s);
            scene.setup_s = up_to(100) / 100.0;
            for (int v = 0; v < 1 + up_to(6); ++v) {
                scene.views.push_back("v" + std::to_string(v));
                scene.view_s.push_back(up_to(10) == 0 ? up_to(1000) / 100.0 : up_to(100) / 100.0);
            }
            scene.shards.assign(scene.views.size(), 0);
        }
    return plan;
}

/// All set-ups where each view pays its own.
double all_alone_s(const Plan& plan) {
    double all = 0;
    for (const PlannedRun& run : plan.runs)
        for (const PlannedScene& scene : run.scenes)
            for (const double view_s : scene.view_s) all += view_s + scene.setup_s;
    return all;
}

double longest_alone_s(const Plan& plan) {
    double longest = 0;
    for (const PlannedRun& run : plan.runs)
        for (const PlannedScene& scene : run.scenes)
            longest = std::max(longest, scene.setup_s + std::ranges::max(scene.view_s));
    return longest;
}

TEST(Assignment, GivesEveryViewAShardAndEndsWithinGrahamsBound) {
    for (std::uint32_t seed = 0; seed < 300; ++seed)
        for (const int shards : {1, 2, 3, 8, 50}) {
            Plan plan = plan_at_random(seed, shards);
            assign(plan);
            for (const PlannedRun& run : plan.runs)
                for (const PlannedScene& scene : run.scenes)
                    for (const int shard : scene.shards) ASSERT_TRUE(shard >= 1 && shard <= shards);
            const double makespan = std::ranges::max(shard_seconds(plan));
            EXPECT_GE(makespan, least_makespan_s(plan) - 1e-9) << seed;
            // A list schedule of jobs that do not depend on one another (Graham 1966): no shard begins its
            // last job later than the mean.
            EXPECT_LE(makespan, all_alone_s(plan) / shards + longest_alone_s(plan) + 1e-9) << seed;
        }
}

TEST(Assignment, OfManyEqualViewsIsEven) {
    Plan plan{.version = "1", .commit = "c", .shards = 7, .runs = {{}}};
    PlannedScene scene{.scene = "s",
                       .views = {},
                       .shards = std::vector<int>(1000, 0),
                       .setup_s = 0.01,
                       .view_s = std::vector<double>(1000, 1)};
    scene.views.assign(1000, "v");
    plan.runs[0].scenes = {scene};
    assign(plan);
    const auto seconds = shard_seconds(plan);
    EXPECT_LE(std::ranges::max(seconds) - std::ranges::min(seconds), 1.02);
}

TEST(Assignment, SetsASceneUpOnceWhereThatIsMostOfTheWork) {
    Plan plan{.version = "1", .commit = "c", .shards = 2, .runs = {{}}};
    for (const char* name : {"a", "b"})
        plan.runs[0].scenes.push_back(
            {.scene = name, .views = {"1", "2"}, .shards = {0, 0}, .setup_s = 10, .view_s = {1, 1}});
    assign(plan);
    for (const PlannedScene& scene : plan.runs[0].scenes) EXPECT_EQ(scene.shards[0], scene.shards[1]);
    EXPECT_NE(plan.runs[0].scenes[0].shards, plan.runs[0].scenes[1].shards);
}

// ---- how long it takes

ViewResult judged(const std::string& scene, std::uint64_t place, std::uint64_t of, double setup_s,
                  double judge_s) {
    ViewResult v;
    v.scene = scene;
    v.view = "v" + std::to_string(place);
    v.view_place = place;
    v.scene_views = of;
    v.width = v.height = 100;
    v.triangles = 10;
    v.times.load = setup_s;
    v.times.judge = judge_s;
    return v;
}

TEST(EarlierRuns, TellViewsAndSeconds) {
    Results results;
    results.views = {judged("a", 0, 2, 3, 1), judged("a", 1, 2, 0, 5), judged("b", 0, 2, 1, 1)};
    const EarlierRun earlier{results};
    const auto a = earlier.scene("a");
    ASSERT_TRUE(a);
    EXPECT_EQ(a->views, (std::vector<std::string>{"v0", "v1"}));
    EXPECT_EQ(a->setup_s, 3);
    EXPECT_EQ(a->view_s, (std::vector<double>{1, 5}));
    EXPECT_FALSE(earlier.scene("b"));  // a view of it was not judged
    EXPECT_FALSE(earlier.scene("c"));
    EXPECT_GT(earlier.slowness(), 10);  // of what ten triangles should take
    EXPECT_EQ(EarlierRun{}.slowness(), 1);
}

// ---- the file

TEST(Plans, AreReadAsTheyWereWritten) {
    const Folder folder;
    Plan plan = plan_at_random(3, 4);
    assign(plan);
    plan.runs[1].name = "mine";
    plan.runs[1].argv = {"run", "a b", "--oracle=none"};
    for (PlannedRun& run : plan.runs) run.selection = {run.scenes.size(), "sum", {{".png", 3}}};
    folder.write("plan.json", to_json(plan));
    const Plan read = read_plan(folder.path() / "plan.json");
    EXPECT_EQ(to_json(read), to_json(plan));
    EXPECT_EQ(read.sha256.size(), 64u);
}

TEST(Plans, ThatAreNoneAreRefused) {
    const Folder folder;
    const std::string good =
        R"({"zproof_plan": 1, "version": "1", "commit": "c", "shards": 2, "runs": [{"name": "",)"
        R"("argv": [], "selection": {"scenes": 1, "sha256": "s", "passed_over": {}},)"
        R"("scenes": [{"scene": "a", "views": ["v"], "shards": [2], "setup_s": 0, "view_s": [1]}]}]})";
    const auto is_read = [&](const std::string& text) {
        folder.write("plan.json", text);
        try {
            read_plan(folder.path() / "plan.json");
        } catch (const ReportError& e) {
            EXPECT_NE(std::string{e.what()}.find("plan.json"), std::string::npos) << e.what();
            return false;
        }
        return true;
    };
    EXPECT_TRUE(is_read(good));
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"\"zproof_plan\": 1", "\"zproof_plan\": 2"},
             {"\"shards\": 2, \"runs\"", "\"shards\": 0, \"runs\""},
             {"[2]", "[3]"},
             {"[2]", "[0]"},
             {"[2]", "[]"},
             {"[1]}", "[1, 2]}"},
             {"\"scenes\": 1", "\"scenes\": 2"},
             {"\"a\"", "7"},
             {"{\"zproof", "\"zproof"}})
        EXPECT_FALSE(is_read(changed(from, to))) << to;
    EXPECT_THROW(read_plan(folder.path() / "none.json"), ReportError);
}

// ---- the whole way

Words plan_words(const Words& more) {
    Words words{"plan",     "near_plane", "coplanar", "room", "models",   "--width", "48",
                "--height", "32",         "--oracle", "none", "--config", "none",    "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

void write_models(const Folder& folder) {
    folder.write("models/a b.gltf", one_triangle());
    folder.write("models/a_b.gltf", two_triangles());
    folder.write("models/cloud.gltf", point_cloud());
    folder.write("models/broken.gltf", "{");
}

/// Runs every shard that there is into shards/NUMBER.
void run_shards(const Folder& folder, const Words& more = {}) {
    const Plan plan = read_plan(folder.path() / "plan.json");
    for (int number = 1; number <= plan.shards; ++number) {
        Words words{"run",
                    "--plan",
                    "plan.json",
                    "--shard",
                    std::to_string(number),
                    "-o",
                    "shards/" + std::to_string(number),
                    "-q"};
        words.insert(words.end(), more.begin(), more.end());
        run(folder, words);
    }
}

Words merge_words(const Folder& folder, const Words& more) {
    Words words{"merge", "--plan", "plan.json", "-o", "out", "--config", "none"};
    for (const auto& shard : fs::directory_iterator(folder.path() / "shards"))
        words.push_back("shards/" + shard.path().filename().string());
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// The run that a plan was made of.
Words words_of_run(const Folder& folder, const Words& more) {
    Words words = read_plan(folder.path() / "plan.json").runs.front().argv;
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Plans, ShardsPutTogetherAreOneRunByteForByteButForTimes) {
    for (const char* count : {"1", "3", "20"}) {
        const Folder whole, parts;
        write_models(whole);
        write_models(parts);
        ASSERT_EQ(run(parts, plan_words({"--of", count})).exit_code, 0);
        fs::copy(parts.path() / "plan.json", whole.path() / "plan.json");
        const Ran one = run(whole, words_of_run(whole, {"-o", "out"}));
        run_shards(parts);
        const Ran merged = run(parts, merge_words(parts, {}));
        EXPECT_EQ(merged.exit_code, one.exit_code) << merged.err;
        expect_same_run(whole.path() / "out", parts.path() / "out");
    }
}

TEST(Plans, AreLaidByWhatAnEarlierRunTook) {
    const Folder folder;
    write_models(folder);
    ASSERT_EQ(run(folder, plan_words({"--of", "1"})).exit_code, 0);
    run(folder, words_of_run(folder, {"-o", "earlier", "-q"}));
    const Ran planned = run(folder, plan_words({"--of", "2", "--from", "earlier"}));
    EXPECT_EQ(planned.exit_code, 0) << planned.err;
    const Plan plan = read_plan(folder.path() / "plan.json");
    const auto room = std::ranges::find(plan.runs[0].scenes, "room", &PlannedScene::scene);
    ASSERT_NE(room, plan.runs[0].scenes.end());
    EXPECT_GE(room->views.size(), 2u);
    run_shards(folder);
    EXPECT_EQ(run(folder, merge_words(folder, {"-q"})).exit_code, 3);  // broken.gltf
    EXPECT_TRUE(fs::exists(folder.path() / "out/results.json"));
}

TEST(Plans, NameWhatIsMissingWithTheCommandThatMakesIt) {
    const Folder folder;
    write_models(folder);
    ASSERT_EQ(run(folder, plan_words({"--of", "3"})).exit_code, 0);
    run_shards(folder);
    fs::remove_all(folder.path() / "shards/2");
    const Ran refused = run(folder, merge_words(folder, {}));
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_NE(
        refused.err.find(
            "shard 2 is missing; to make it: zproof run --plan plan.json --shard 2 --exit-zero --report "
            "json -o shards/2"),
        std::string::npos)
        << refused.err;
    EXPECT_FALSE(fs::exists(folder.path() / "out"));

    const Ran partial = run(folder, merge_words(folder, {"--partial"}));
    EXPECT_EQ(partial.exit_code, 3) << partial.err;
    const std::string results = folder.read("out/results.json");
    EXPECT_NE(results.find("\"ending\": \"partial\""), std::string::npos);
    EXPECT_NE(results.find("shard 2 is missing"), std::string::npos);

    run(folder, {"run", "--plan", "plan.json", "--shard", "2", "-o", "shards/2", "-q"});
    EXPECT_NE(run(folder, merge_words(folder, {})).err.find("out/report.html"), 0u);
}

TEST(Plans, DoNotTakeShardsOfOtherPlansOrNamedTwice) {
    const Folder folder;
    write_models(folder);
    run(folder, plan_words({"--of", "2"}));
    run_shards(folder);
    fs::copy(folder.path() / "shards/1", folder.path() / "shards/again", fs::copy_options::recursive);
    const Ran twice = run(folder, merge_words(folder, {}));
    EXPECT_EQ(twice.exit_code, 3);
    EXPECT_NE(twice.err.find("name every shard once"), std::string::npos) << twice.err;
    fs::remove_all(folder.path() / "shards/again");
    run(folder, plan_words({"--of", "2", "--strict"}));
    const Ran foreign = run(folder, merge_words(folder, {}));
    EXPECT_EQ(foreign.exit_code, 3);
    EXPECT_NE(foreign.err.find("of another plan"), std::string::npos) << foreign.err;
    EXPECT_NE(foreign.err.find("shard 1 is missing"), std::string::npos) << foreign.err;
}

TEST(Plans, RefuseScenesThatCameLater) {
    const Folder folder;
    write_models(folder);
    run(folder, plan_words({"--of", "2"}));
    folder.write("models/new.gltf", one_triangle());
    const Ran ran = run(folder, {"run", "--plan", "plan.json", "--shard", "1", "-q"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_NE(ran.err.find("other scenes"), std::string::npos) << ran.err;
}

TEST(Plans, RefuseASceneThatLostItsViews) {
    const Folder folder;
    write_models(folder);
    run(folder, plan_words({"--of", "1"}));
    folder.write("models/a_b.gltf", point_cloud());
    const Ran ran = run(folder, {"run", "--plan", "plan.json", "--shard", "1", "-q"});
    EXPECT_NE(folder.read("zproof-out/results.json").find("other views than the plan says"),
              std::string::npos)
        << ran.err;
}

TEST(Plans, StateAllButTheShard) {
    const Folder folder;
    write_models(folder);
    run(folder, plan_words({"--of", "2"}));
    for (const Words& more :
         {Words{"--width", "9"}, Words{"room"}, Words{"--renderer", "opengl"}, Words{"--strict"}}) {
        Words words{"run", "--plan", "plan.json", "--shard", "1", "-q"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(run(folder, words).exit_code, 2) << more.front();
    }
    EXPECT_EQ(run(folder, {"run", "--plan", "plan.json", "-q"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"run", "--plan", "plan.json", "--shard", "3", "-q"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"run", "--plan", "plan.json", "--shard", "1/3", "-q"}).exit_code, 2);
    folder.write("zproof.toml", "width = 9\nscenes = [\"coplanar\"]\n");  // the plan has the last word
    run(folder, {"run", "--plan", "plan.json", "--shard", "1", "-q", "-o", "shard"});
    EXPECT_NE(folder.read("shard/results.json").find("\"width\": 48"), std::string::npos);
}

TEST(Plans, OfSeveralProfilesHaveARunOfEach) {
    const Folder folder;
    folder.write("zproof.toml",
                 "scenes = [\"near_plane\", \"room\"]\noracle = [\"none\"]\nwidth = 48\nheight = 32\n"
                 "[profiles.ours]\nrenderer = \"zproof\"\n[profiles.theirs]\nrenderer = \"embree\"\n"
                 "precision = \"raster,subpixel_bits=8\"\n");
    const Ran planned = run(folder, {"plan", "--of", "2", "--profile", "ours", "--profile", "theirs", "-q"});
    ASSERT_EQ(planned.exit_code, 0) << planned.err;
    const Plan plan = read_plan(folder.path() / "plan.json");
    ASSERT_EQ(plan.runs.size(), 2u);
    EXPECT_EQ(plan.runs[1].name, "theirs");
    for (const char* number : {"1", "2"})
        run(folder,
            {"run", "--plan", "plan.json", "--shard", number, "-o", std::string{"shards/"} + number, "-q"});
    const Ran merged =
        run(folder, {"merge", "--plan", "plan.json", "shards/1", "shards/2", "-o", "out", "-q"});
    EXPECT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_NE(folder.read("out/ours/results.json").find("\"candidate\": \"zproof\""), std::string::npos);
    EXPECT_NE(folder.read("out/theirs/results.json").find("\"candidate\": \"embree\""), std::string::npos);
}

TEST(Plans, PrintCommandsForEachEngine) {
    const Folder folder;
    write_models(folder);
    const Ran lines = run(folder, plan_words({"--of", "2", "-o", "my plan.json"}));
    EXPECT_EQ(lines.out,
              "zproof run --plan 'my plan.json' --shard 1 --exit-zero --report json -o shards/1\n"
              "zproof run --plan 'my plan.json' --shard 2 --exit-zero --report json -o shards/2\n");
    EXPECT_NE(run(folder, plan_words({"--of", "9", "--format", "slurm"})).out.find("#SBATCH --array=1-9\n"),
              std::string::npos);
    EXPECT_EQ(run(folder, plan_words({"--of", "3", "--format", "github"})).out, "{\"shard\":[1,2,3]}\n");
    EXPECT_NE(run(folder, plan_words({"--of", "3", "--format", "gitlab"})).out.find("parallel: 3\n"),
              std::string::npos);
}

}  // namespace
}  // namespace zproof::test
