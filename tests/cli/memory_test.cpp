// What is said where there is not enough memory for a view.
#include "cli/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/cli/program.h"

namespace zproof {
namespace {

/// Of programs that are started meanwhile, too.
class AddressSpace {
  public:
    explicit AddressSpace(std::uint64_t bytes) {
        getrlimit(RLIMIT_AS, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_AS, &limit);
    }
    ~AddressSpace() { setrlimit(RLIMIT_AS, &before_); }

  private:
    rlimit before_{};
};

constexpr std::uint64_t gib = std::uint64_t{1} << 30;

TEST(Memory, OfALimitIsWhatIsLeftOfIt) {
    const AddressSpace limit{4 * gib};
    EXPECT_LT(available_memory_bytes(), 4 * gib);
    EXPECT_GT(available_memory_bytes(), gib / 4);
}

TEST(Memory, NeededForAViewIsComparedWithWhatThereIs) {
    const AddressSpace limit{4 * gib};
    EXPECT_EQ(least_memory_bytes({1000, 1000}), 17'000'000u);
    EXPECT_EQ(lacking_memory({1000, 1000}), "");
    const std::string lacking = lacking_memory({16384, 16384});
    EXPECT_NE(lacking.find("16384 x 16384 pixels need at least 4.25 GiB of memory, of which "),
              std::string::npos)
        << lacking;
    EXPECT_NE(lacking.find("GiB is there; make the picture smaller"), std::string::npos) << lacking;
}

using test::Folder;
using test::Ran;

constexpr std::uint64_t no_limit = std::uint64_t(-1);

TEST(Memory, OfControlGroupsIsTheLeastOfThoseAbove) {
    const Folder groups;
    groups.write("memory.max", "max\n");
    groups.write("a/memory.max", "1000\n");
    groups.write("a/memory.current", "300\n");
    groups.write("a/b/memory.max", "900\n");
    groups.write("a/b/memory.current", "100\n");
    groups.write("a/b/c/memory.max", "max\n");
    groups.write("a/b/c/memory.current", "100\n");
    const auto left = [&](const char* line) { return memory_left_of_groups(line, groups.path()); };
    EXPECT_EQ(left("4:memory:/x\n0::/a/b/c\n"), 700u) << "a leaves less than b";
    EXPECT_EQ(left("0::/a\n"), 700u);
    EXPECT_EQ(left("0::/elsewhere\n"), no_limit);
    EXPECT_EQ(left("0::/\n"), no_limit);
    EXPECT_EQ(left("4:memory:/a\n"), no_limit) << "of cgroup v1";
}

TEST(Memory, OfAControlGroupIsWithoutThePagesOfFiles) {
    const Folder groups;
    groups.write("memory.max", "1000\n");
    groups.write("memory.current", "950\n");
    groups.write("memory.stat", "anon 100\nfile 850\ninactive_file 300\nactive_file 500\nshmem 50\n");
    EXPECT_EQ(memory_left_of_groups("0::/\n", groups.path()), 850u);
    groups.write("memory.current", "2000\n");
    groups.write("memory.stat", "");
    EXPECT_EQ(memory_left_of_groups("0::/\n", groups.path()), 0u) << "in excess of a limit set later";
}

/// The view is a result, and the next scene is judged.
TEST(Memory, ThatLacksForAViewIsSaidOfThatView) {
    const Folder folder;
    folder.write("one.gltf", test::one_triangle());
    folder.write("huge.view.json", R"({"scene": "one.gltf", "views": [{"name": "poster", "width": 16384,
        "height": 16384, "projection": "perspective", "yfov_degrees": 60, "eye": [0, 0, 0],
        "target": [0, 0, -3], "up": [0, 1, 0], "near": 0.1, "far": 100}]})");
    const AddressSpace limit{4 * gib};
    const Ran ran = run(folder, {"run", "huge.view.json", "one.gltf", "--oracle", "none", "--threads", "1",
                                 "--width", "16", "--height", "12", "-o", "out"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("huge/poster"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("16384 x 16384 pixels need at least 4.25 GiB of memory"), std::string::npos)
        << ran.out << ran.err;
    EXPECT_NE(ran.out.find("proven"), std::string::npos) << ran.out;
}

TEST(Memory, ThatLacksEndsOtherCommandsWithStatus3) {
    const Folder folder;
    folder.write("one.gltf", test::one_triangle());
    const AddressSpace limit{4 * gib};
    for (const test::Words& words :
         {test::Words{"render", "one.gltf"}, test::Words{"explain", "one.gltf", "3", "3"}}) {
        test::Words whole = words;
        whole.insert(whole.end(), {"--threads", "1", "--width", "16384", "--height", "16384"});
        const Ran ran = run(folder, whole);
        EXPECT_EQ(ran.exit_code, 3) << ran.err;
        EXPECT_NE(ran.err.find("pixels need at least 4.25 GiB of memory"), std::string::npos) << ran.err;
    }
}

}  // namespace
}  // namespace zproof
