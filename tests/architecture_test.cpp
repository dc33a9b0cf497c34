// The house plan of docs/design.md as a test: who may look into which room, and how long a file may grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// A room may look only into the rooms named here, and into itself.
const std::map<std::string, Names> may_include{
    {"math", {}},
    {"frame", {"math"}},
    {"scenes", {"math"}},
    {"texture", {"math"}},
    {"rasterizer", {"math", "frame", "scenes", "texture"}},
    {"oracle", {"math", "frame", "scenes", "texture"}},
    {"compare", {"math", "frame", "scenes"}},  // judges evidence; never meets a renderer
    {"measure", {"math", "frame", "scenes"}},  // is handed a renderer as a function; knows none
    {"study",
     {"math", "frame", "scenes", "texture", "rasterizer", "oracle",
      "compare"}},                                          // holds a method to its truth
    {"reports", {"compare", "measure", "study", "frame"}},  // shows results; never computes one
    {"cli",
     {"math", "frame", "scenes", "texture", "rasterizer", "oracle", "compare", "measure", "study",
      "reports"}},
};

/// The judge's own rooms: what each may look into beside itself and what stands in compare/ itself.
const std::map<std::string, Names> may_include_in_compare{
    {"bounds", {}},
    {"truth", {"bounds"}},
    {"search", {"bounds", "truth"}},
    {"strips", {"bounds"}},
    {"first_pass", {"bounds", "strips"}},
    {"layers", {"bounds", "truth", "search", "strips", "first_pass"}},
    {"hearing", {"bounds", "truth", "search", "strips", "first_pass"}},
    {"diagnosis", {"search", "hearing"}},
    {"explanation", {"truth", "search", "hearing"}},
    {"metrics", {}},
    {"waivers", {}},
};

/// Where a foreign library is spoken to; everywhere else it is unknown. <iostream>: library rooms never
/// print.
const std::map<std::string, Names> spoken_to_in{
    {"embree3/", {"oracle"}},    {"EGL/", {"oracle"}},
    {"GL/", {"oracle"}},         {"OpenImageIO/", {"oracle"}},
    {"tiny_gltf.h", {"scenes"}}, {"nlohmann/", {"frame", "scenes", "reports"}},
    {"CLI/", {"cli"}},           {"nettle/", {"math"}},
    {"toml++/", {"cli"}},        {"Eigen/", {"study"}},
    {"iostream", {"cli"}},       {"cstdio", {}},
    {"isa-l/", {"frame"}},       {"OpenEXR/", {"frame"}},
};

constexpr std::size_t longest_line = 110, longest_file = 600, comfortable_header = 150;

struct SourceFile {
    std::string path;  ///< relative to the repository
    std::string room;  ///< its first folder
    std::vector<std::string> lines;
};

std::vector<std::string> lines_of(std::istream& in) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

bool is_source(const fs::path& file) {
    return file.extension() == ".h" || file.extension() == ".cpp" || file.extension() == ".inl";
}

/// Every source below the named top folders that exist.
std::vector<SourceFile> sources_in(const Names& folders) {
    const fs::path root = ZPROOF_SOURCE_DIR;
    std::vector<SourceFile> files;
    for (const std::string& folder : folders) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator{root / folder}) {
            if (!is_source(entry.path())) continue;
            std::ifstream in{entry.path()};
            files.push_back({fs::relative(entry.path(), root).generic_string(), folder, lines_of(in)});
        }
    }
    return files;
}

Names rooms() {
    Names names;
    for (const auto& [room, allowed] : may_include) names.insert(room);
    return names;
}

Names all_folders() {
    Names names = rooms();
    names.insert({"tests", "examples", "bench"});
    return names;
}

std::string at(const SourceFile& file, std::size_t line) {
    return file.path + ":" + std::to_string(line + 1) + ": ";
}

/// What is wrong with #include "header" in this room; empty where nothing is.
std::string fault_of_own_header(const std::string& room, const std::string& header) {
    const std::string target = header.substr(0, header.find('/'));
    if (!may_include.contains(target)) return "\"" + header + "\" does not begin with the name of a room";
    if (target == room || may_include.at(room).contains(target)) return "";
    return room + "/ may not look into " + target + "/ (docs/design.md, Architecture)";
}

std::string fault_of_foreign_header(const std::string& room, const std::string& header) {
    for (const auto& [prefix, speakers] : spoken_to_in)
        if (header.starts_with(prefix) && !speakers.contains(room))
            return ("<" + header).append("> has no place in ").append(room).append("/");
    return "";
}

/// The second folder of a path below compare/; empty where it has none.
std::string room_in_compare(const std::string& path) {
    static const std::regex inner{"^compare/([^/]+)/.*"};
    std::smatch match;
    return std::regex_match(path, match, inner) ? match[1].str() : "";
}

std::string fault_within_compare(const std::string& path, const std::string& header) {
    const std::string room = room_in_compare(path), target = room_in_compare(header);
    if (room.empty() || target.empty() || room == target) return "";
    const auto allowed = may_include_in_compare.find(room);
    if (allowed == may_include_in_compare.end()) return "compare/" + room + "/ is no room of the house";
    if (allowed->second.contains(target)) return "";
    return ("compare/" + room)
        .append("/ may not look into compare/")
        .append(target)
        .append("/ (docs/design.md, The house)");
}

std::vector<std::string> include_faults(const SourceFile& file) {
    static const std::regex include{R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re"};
    std::vector<std::string> faults;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        std::smatch match;
        if (!std::regex_search(file.lines[i], match, include)) continue;
        const bool own = match[1] == "\"";
        for (const std::string& fault :
             {own ? fault_of_own_header(file.room, match[2]) : fault_of_foreign_header(file.room, match[2]),
              fault_within_compare(file.path, match[2])})
            if (!fault.empty()) faults.push_back(at(file, i) + fault);
    }
    return faults;
}

/// Characters, not bytes: UTF-8 continuation bytes do not count.
std::size_t width_of(const std::string& line) {
    return std::size_t(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<std::string> size_faults(const SourceFile& file) {
    std::vector<std::string> faults;
    for (std::size_t i = 0; i < file.lines.size(); ++i)
        if (width_of(file.lines[i]) > longest_line) faults.push_back(at(file, i) + "longer than 110 columns");
    if (file.lines.size() > longest_file)
        faults.push_back(file.path + ": " + std::to_string(file.lines.size()) +
                         " lines, at most 600: two rooms in one");
    return faults;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += "\n  " + line;
    return text;
}

TEST(HousePlan, EveryRoomLooksOnlyIntoTheRoomsItMay) {
    const std::vector<SourceFile> files = sources_in(rooms());
    ASSERT_FALSE(files.empty());
    std::vector<std::string> faults;
    for (const SourceFile& file : files) std::ranges::move(include_faults(file), std::back_inserter(faults));
    EXPECT_TRUE(faults.empty()) << joined(faults);
}

TEST(HousePlan, FilesAndLinesKeepTheirLimits) {
    std::vector<std::string> faults;
    for (const SourceFile& file : sources_in(all_folders())) {
        std::ranges::move(size_faults(file), std::back_inserter(faults));
        if (file.path.ends_with(".h") && file.lines.size() > comfortable_header)
            std::cout << "warning: " << file.path << " has " << file.lines.size() << " lines\n";
    }
    EXPECT_TRUE(faults.empty()) << joined(faults);
}

TEST(HousePlan, APlantedIntruderIsNamed) {
    const SourceFile file{
        "rasterizer/a.cpp", "rasterizer", {"// first line", "#include \"compare/judge.h\""}};
    ASSERT_EQ(include_faults(file).size(), 1u);
    EXPECT_EQ(include_faults(file)[0].find("rasterizer/a.cpp:2: rasterizer/ may not look into compare/"), 0u);
    EXPECT_EQ(include_faults({"reports/a.cpp", "reports", {"  # include <iostream>"}}).size(), 1u);
    EXPECT_EQ(include_faults({"oracle/a.cpp", "oracle", {"#include \"embree.h\""}}).size(), 1u);
    EXPECT_TRUE(include_faults({"oracle/a.cpp", "oracle", {"#include <embree3/rtcore.h>"}}).empty());
    const std::vector<std::string> judge{"#include \"compare/judge.h\""},
        hearing{"#include \"compare/hearing/hearing.h\""};
    EXPECT_TRUE(include_faults({"compare/truth/a.cpp", "compare", judge}).empty());
    EXPECT_TRUE(include_faults({"compare/diagnosis/hypotheses/a.cpp", "compare", hearing}).empty());
    EXPECT_EQ(include_faults({"compare/truth/a.cpp", "compare", hearing}).size(), 1u);
    EXPECT_EQ(include_faults({"compare/attic/a.cpp", "compare", hearing}).size(), 1u);
}

TEST(HousePlan, APlantedGiantIsNamed) {
    EXPECT_TRUE(size_faults({"math/a.h", "math", std::vector<std::string>(600)}).empty());
    EXPECT_EQ(size_faults({"math/a.h", "math", std::vector<std::string>(601)}).size(), 1u);
    EXPECT_TRUE(size_faults({"math/a.h", "math", {std::string(109, 'x') + "\u00e9"}}).empty());
    EXPECT_EQ(size_faults({"math/a.h", "math", {std::string(111, 'x')}}).size(), 1u);
}

TEST(HousePlan, EveryPackageHasItsReason) {
    const fs::path root = ZPROOF_SOURCE_DIR;
    std::ifstream packages{root / "cmake/packages.txt"}, reasons{root / "docs/dependencies.md"};
    std::stringstream text;
    text << reasons.rdbuf();
    for (const std::string& line : lines_of(packages)) {
        if (line.empty() || line.starts_with('#')) continue;
        const std::size_t colon = line.find(": ");  // "check: ", "bench: "
        const std::string name = colon == std::string::npos ? line : line.substr(colon + 2);
        EXPECT_NE(text.str().find("| `" + name + "` |"), std::string::npos)
            << name << " is not in docs/dependencies.md";
    }
}

}  // namespace
