// Shards put together are one run, byte for byte but for times.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "cli/gate/shard.h"
#include "program/usage_error.h"
#include "scenes/scene_error.h"
#include "tests/cli/program.h"
#include "tests/cli/same_run.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

Words run_words(const Words& more) {
    Words words{"run", "near_plane", "coplanar", "models",   "--width", "48", "--height",
                "32",  "--oracle",   "none",     "--config", "none",    "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Suite scenes, and two files whose evidence would go into one folder.
void write_models(const Folder& folder) {
    folder.write("models/a b.gltf", one_triangle());
    folder.write("models/a_b.gltf", two_triangles());
    folder.write("models/cloud.gltf", point_cloud());
}

TEST(Shards, PutTogetherAreOneRunByteForByteButForTimes) {
    const Folder whole;
    write_models(whole);
    const Ran one = run(whole, run_words({"--report", "html,junit,md,csv", "-o", "out"}));
    for (const int count : {1, 2, 3, 9}) {
        const Folder parts;
        write_models(parts);
        Words merge{"merge"};
        int empty = 0;
        for (int number = 1; number <= count; ++number) {
            const std::string out = "shard" + std::to_string(number);
            const std::string shard = "hash:" + std::to_string(number) + "/" + std::to_string(count);
            const Ran part =
                run(parts, run_words({"--report", "html,junit,md,csv", "--shard", shard, "-o", out}));
            if (part.exit_code == 4) ++empty;
            EXPECT_TRUE(part.exit_code == one.exit_code || part.exit_code == 4) << part.err;
            merge.insert(merge.begin() + 1, out);  // the order does not count
        }
        EXPECT_EQ(empty > 0, count == 9);
        merge.insert(merge.end(), {"--report", "html,junit,md,csv", "-o", "out", "-q", "--config", "none"});
        const Ran merged = run(parts, merge);
        EXPECT_EQ(merged.exit_code, one.exit_code) << merged.err;
        EXPECT_EQ(merged.out, one.out);
        expect_same_run(whole.path() / "out", parts.path() / "out");
    }
}

TEST(Shards, OfDifferentRunsAreNotPutTogether) {
    const Folder folder;
    write_models(folder);
    run(folder, run_words({"--shard", "hash:1/2", "-o", "one"}));
    Words other = run_words({"--shard", "hash:2/2", "-o", "two"});
    other[5] = "64";
    run(folder, other);
    const Ran ran = run(folder, {"merge", "one", "two", "-o", "out"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_NE(ran.err.find("resolution differs"), std::string::npos) << ran.err;
    EXPECT_EQ(run(folder, {"merge", "one", "-o", "out"}).exit_code, 3);
    EXPECT_EQ(run(folder, {"merge", "one", "one", "-o", "out"}).exit_code, 3);
    EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

std::vector<SceneSource> scenes(int count) {
    std::vector<SceneSource> sources;
    for (int i = 0; i < count; ++i)
        sources.push_back(
            {SceneSource::Kind::suite, "scene" + std::to_string(i), "suite", "", {}, std::uint64_t(i)});
    return sources;
}

std::vector<View> views(int count) {
    std::vector<View> all(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) all[std::size_t(i)].name = "v" + std::to_string(i);
    return all;
}

TEST(Shards, HoldEveryViewOnceAndSpreadASceneEvenly) {
    const auto all = scenes(60);
    for (const int count : {1, 2, 3, 7, 100}) {
        std::multiset<std::pair<std::string, std::size_t>> seen;
        for (int number = 1; number <= count; ++number)
            for (const SceneSource& s : share_of(all, {.number = number, .count = count})) {
                const auto places = places_in(s.share, views(9));
                EXPECT_LE(places.size(), std::size_t(9 / count + 1));
                for (const std::size_t place : places) seen.emplace(s.name, place);
            }
        EXPECT_EQ(seen.size(), all.size() * 9) << count;
        EXPECT_EQ((std::set(seen.begin(), seen.end()).size()), all.size() * 9) << count;
    }
}

TEST(Shards, DoNotDependOnTheSelection) {
    const auto few = share_of(scenes(10), {.number = 2, .count = 3}),
               many = share_of(scenes(60), {.number = 2, .count = 3});
    for (std::size_t i = 0; i < few.size(); ++i)
        EXPECT_EQ(places_in(few[i].share, views(5)), places_in(many[i].share, views(5)));
}

TEST(Shards, OfAPlanRefuseASceneThatHasOtherViews) {
    const ViewShare share{.planned = PlannedViews{.all = {"v0", "v1"}, .wanted = {1}}};
    EXPECT_EQ(places_in(share, views(2)), std::vector<std::size_t>{1});
    EXPECT_THROW(places_in(share, views(3)), SceneError);
}

const Environment nowhere = [](const std::string&) -> const char* { return nullptr; };

TEST(Shards, AreNamedInOneWay) {
    EXPECT_EQ(shard_from("hash:2/3", false, nowhere).number, 2);
    EXPECT_EQ(shard_from("hash:2/3", false, nowhere).count, 3);
    EXPECT_EQ(shard_from("", false, nowhere).count, 1);
    for (const char* word : {"2", "2/3", "hash:0/3", "hash:4/3", "hash:1/0", "hash:1/x", "hash:1",
                             "hash:-1/3", "hash:1/10001", "hash: 1/3", "auto"})
        EXPECT_THROW(shard_from(word, false, nowhere), UsageError) << word;
}

TEST(Shards, OfAPlanAreNamedByTheirNumbers) {
    EXPECT_EQ(shard_from("2", true, nowhere).number, 2);
    EXPECT_EQ(shard_from("2", true, nowhere).count, 0);
    EXPECT_EQ(shard_from("2/3", true, nowhere).count, 3);
    for (const char* word : {"", "0", "hash:2/3", "4/3", "x", "-1", "auto"})
        EXPECT_THROW(shard_from(word, true, nowhere), UsageError) << word;
}

using Variables = std::map<std::string, std::string>;

Environment environment_of(const Variables& variables) {
    return [variables](const std::string& name) -> const char* {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    };
}

TEST(Shards, AreTakenFromTheEnvironmentEachWithItsOwnOrigin) {
    struct Case {
        Variables variables;
        int number, count;
        const char* taken_from;
    };
    const std::vector<Case> cases{
        {{{"SLURM_ARRAY_TASK_ID", "7"}, {"SLURM_ARRAY_TASK_MIN", "5"}, {"SLURM_ARRAY_TASK_COUNT", "4"}},
         3,
         4,
         "SLURM_ARRAY_TASK_ID"},
        {{{"SLURM_ARRAY_TASK_ID", "20"},
          {"SLURM_ARRAY_TASK_MIN", "0"},
          {"SLURM_ARRAY_TASK_STEP", "10"},
          {"SLURM_ARRAY_TASK_COUNT", "3"}},
         3,
         3,
         "SLURM_ARRAY_TASK_ID"},
        {{{"CI_NODE_INDEX", "1"}, {"CI_NODE_TOTAL", "2"}}, 1, 2, "CI_NODE_INDEX"},
        {{{"TEST_SHARD_INDEX", "0"}, {"TEST_TOTAL_SHARDS", "2"}}, 1, 2, "TEST_SHARD_INDEX"},
        {{{"PMI_RANK", "3"}, {"PMI_SIZE", "4"}}, 4, 4, "PMI_RANK"},
        {{{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "4"}}, 1, 4, "OMPI_COMM_WORLD_RANK"},
        {{{"CI_NODE_INDEX", "2"}, {"CI_NODE_TOTAL", "2"}, {"PMI_RANK", "0"}, {"PMI_SIZE", "9"}},
         2,
         2,
         "CI_NODE_INDEX"},
    };
    for (const auto& [variables, number, count, taken_from] : cases)
        for (const bool has_plan : {false, true}) {
            const Shard shard = shard_from("auto", has_plan, environment_of(variables));
            EXPECT_EQ(shard.number, number) << taken_from;
            EXPECT_EQ(shard.count, count) << taken_from;
            EXPECT_EQ(shard.taken_from, taken_from);
        }
}

TEST(Shards, WithoutACountInTheEnvironmentNeedAPlan) {
    const Environment kubernetes = environment_of({{"JOB_COMPLETION_INDEX", "4"}});
    EXPECT_EQ(shard_from("auto", true, kubernetes).number, 5);
    EXPECT_THROW(shard_from("auto", false, kubernetes), UsageError);
}

TEST(Shards, OutsideTheirCountAreRefused) {
    for (const Variables& variables :
         {Variables{{"CI_NODE_INDEX", "0"}, {"CI_NODE_TOTAL", "2"}},
          Variables{{"CI_NODE_INDEX", "3"}, {"CI_NODE_TOTAL", "2"}},
          Variables{{"PMI_RANK", "2"}, {"PMI_SIZE", "2"}}, Variables{{"PMI_RANK", "x"}, {"PMI_SIZE", "2"}},
          Variables{{"PMI_RANK", "-1"}, {"PMI_SIZE", "2"}},
          Variables{
              {"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_MIN", "3"}, {"SLURM_ARRAY_TASK_COUNT", "2"}}})
        EXPECT_THROW(shard_from("auto", false, environment_of(variables)), UsageError)
            << variables.begin()->first << " " << variables.begin()->second;
}

TEST(Shards, TellBazelThatTheyAreListenedTo) {
    const Folder folder;
    const fs::path file = folder.path() / "status";
    shard_from("auto", false,
               environment_of({{"TEST_SHARD_INDEX", "0"},
                               {"TEST_TOTAL_SHARDS", "2"},
                               {"TEST_SHARD_STATUS_FILE", file.string()}}));
    EXPECT_TRUE(fs::exists(file));
}

TEST(Shards, WithoutAViewMayEndWithZero) {
    const Folder folder;
    for (const char* number : {"1", "2", "3"}) {
        const Words words{"run",
                          "degenerate",
                          "--width",
                          "16",
                          "--height",
                          "16",
                          "--oracle",
                          "none",
                          "--config",
                          "none",
                          "-q",
                          "--shard",
                          std::string{"hash:"} + number + "/3"};
        const int plain = run(folder, words).exit_code;
        Words ok = words;
        ok.insert(ok.end(), {"--empty-shard", "ok"});
        EXPECT_TRUE(plain == 0 || plain == 4) << plain;
        EXPECT_EQ(run(folder, ok).exit_code, 0);
    }
}

TEST(Shards, MayEndWithZeroWhateverTheirResultsAre) {
    const Folder folder;
    folder.write("broken.gltf", "{");
    const Words words{"run", "broken.gltf", "--oracle", "none", "--config", "none", "-q", "-o", "out"};
    const auto ends = [&](Words more) {
        more.insert(more.begin(), words.begin(), words.end());
        return run(folder, more).exit_code;
    };
    EXPECT_EQ(ends({"--shard", "hash:1/1"}), 3);
    EXPECT_EQ(ends({"--shard", "hash:1/1", "--exit-zero"}), 0);
    EXPECT_EQ(ends({"--shard", "hash:1/1", "--exit-zero", "--waivers", "none.toml"}), 3);  // nothing written
    EXPECT_EQ(ends({"--exit-zero"}), 2);
}

}  // namespace
}  // namespace zproof::test
