// Shards put together are one run, byte for byte but for times.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "cli/gate/shard.h"
#include "cli/usage_error.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

Words run_words(const Words& more) {
    Words words{"run", "near_plane", "coplanar", "models",   "--width", "48", "--height",
                "32",  "--oracle",   "none",     "--config", "none",    "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Every file below the folder, by its relative name.
std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator{folder})
        if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).generic_string());
    return files;
}

/// The file with every time struck out: seconds in results.json, of cases in junit.xml and on the page. The
/// list of files keeps their names alone, for their lengths and sums hold the times.
std::string without_times(const std::string& text, const std::string& name) {
    if (name == "results.json") {
        auto results = nlohmann::ordered_json::parse(text);
        for (auto& view : results.at("views"))
            for (auto& time : view.at("times")) time = 0;
        return results.dump(1);
    }
    if (name == "junit.xml") return std::regex_replace(text, std::regex{"time=\"[0-9.]+\""}, "time=\"\"");
    if (name == ".zproof-out") return std::regex_replace(text, std::regex{"[0-9]+ [0-9a-f]+ "}, "- ");
    if (name != "report.html") return text;
    return std::regex_replace(text, std::regex{"[0-9]+\\.[0-9]{2}( s</span>|</td></tr>)"}, "-$1");
}

void expect_same_files(const Folder& a, const Folder& b) {
    ASSERT_EQ(files_in(a.path() / "out"), files_in(b.path() / "out"));
    for (const std::string& name : files_in(a.path() / "out"))
        EXPECT_TRUE(without_times(a.read("out/" + name), name) == without_times(b.read("out/" + name), name))
            << name;
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
        expect_same_files(whole, parts);
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

TEST(Shards, HoldEverySceneOnceAndDoNotDependOnTheSelection) {
    const auto all = scenes(60);
    for (const int count : {1, 2, 3, 7, 100}) {
        std::multiset<std::string> seen;
        for (int number = 1; number <= count; ++number)
            for (const SceneSource& s : share_of(all, {number, count})) seen.insert(s.name);
        EXPECT_EQ(seen.size(), all.size());
        EXPECT_EQ(std::set<std::string>(seen.begin(), seen.end()).size(), all.size());
    }
    const auto few = share_of(scenes(10), {2, 3}), many = share_of(all, {2, 3});
    ASSERT_LT(few.size(), many.size());
    for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].name, many[i].name);
}

TEST(Shards, AreNamedInOneWay) {
    EXPECT_EQ(shard_from("hash:2/3").number, 2);
    EXPECT_EQ(shard_from("hash:2/3").count, 3);
    for (const char* word : {"", "2/3", "hash:0/3", "hash:4/3", "hash:1/0", "hash:1/x", "hash:1", "hash:-1/3",
                             "hash:1/10001", "hash: 1/3"})
        EXPECT_THROW(shard_from(word), UsageError) << word;
}

}  // namespace
}  // namespace zproof::test
