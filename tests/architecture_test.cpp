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
    {"image_io", {"frame"}},
    {"scenes", {"math", "frame", "image_io"}},
    {"texture", {"math"}},
    {"rasterizer", {"math", "frame", "scenes", "texture"}},
    {"oracle", {"math", "frame", "image_io", "scenes", "texture"}},
    {"compare", {"math", "frame", "scenes"}},             // judges evidence; never meets a renderer
    {"measure", {"math", "frame", "scenes", "compare"}},  // is handed a renderer as a function; knows none
    {"reports", {"math", "compare", "measure", "frame", "image_io"}},  // shows results; never computes one
    {"program",
     {"math", "frame", "scenes", "oracle", "compare", "reports"}},  // what every program is made of
    {"selftest",
     {"math", "frame", "scenes", "rasterizer", "oracle", "compare", "program"}},  // lies to the judge
    {"renderers",
     {"math", "frame", "image_io", "scenes", "rasterizer", "oracle", "compare", "measure", "reports",
      "program"}},  // who can be asked
    {"filters",
     {"math", "frame", "image_io", "scenes", "texture", "rasterizer", "oracle", "compare", "reports",
      "program"}},  // holds a method to its truth
    {"lessons", {"math", "frame", "scenes", "rasterizer", "oracle", "compare", "reports", "program"}},
    {"zproof",
     {"math", "frame", "image_io", "scenes", "rasterizer", "oracle", "compare", "reports",
      "filters"}},  // the public interface
    {"cli",
     {"math", "frame", "image_io", "scenes", "rasterizer", "oracle", "compare", "measure", "reports",
      "program", "selftest", "renderers"}},
};

/// The judge's own rooms: what each may look into beside itself.
const std::map<std::string, Names> may_include_in_compare{
    {"bounds", {}},
    {"admissible", {"bounds"}},
    {"agree", {"bounds"}},
    {"attributes", {"bounds", "admissible"}},
    {"adjudicate", {"bounds", "admissible", "agree", "attributes"}},
    {"diagnosis", {"bounds", "admissible", "adjudicate", "attributes", "labels"}},
    {"explanation", {"bounds", "admissible", "agree", "adjudicate"}},
    {"labels", {"bounds", "admissible", "adjudicate"}},
    {"waivers", {}},
};

/// What stands in compare/ itself: every room may look at its types, and rooms above the judge at the judge.
const Names types_of_compare{"pixel_class.h", "finding.h", "verdict.h", "rendered_frame.h"};
const Names rooms_above_the_judge{"diagnosis", "explanation"};
/// The rooms that its own files may look into; those that are not named, into none.
const std::map<std::string, Names> may_include_from_compare{
    {"judge.cpp", {"agree", "adjudicate", "attributes"}},
    {"rendered_frame.h", {"bounds"}},
    {"finding.h", {"bounds", "attributes"}},
};

/// Where a foreign library is spoken to; everywhere else it is unknown. <iostream>: library rooms never
/// print.
const std::map<std::string, Names> spoken_to_in{
    {"embree", {"oracle"}},
    {"EGL/", {"oracle"}},
    {"GL/", {"oracle"}},
    {"vulkan/", {"oracle"}},
    {"OpenImageIO/", {"image_io"}},
    {"tiny_gltf.h", {"scenes"}},
    {"nlohmann/", {"frame", "scenes", "reports", "program", "filters"}},
    {"CLI/", {"cli", "program", "filters", "lessons"}},
    {"nettle/", {"math"}},
    {"toml++/", {"program"}},
    {"Eigen/", {"lessons"}},
    {"iostream", {"cli", "program", "filters", "lessons"}},
    {"cstdio", {}},
    {"isa-l/", {"reports"}},
    {"OpenEXR/", {}},
    {"dlfcn.h", {"image_io"}},
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
    names.insert({"tests", "examples", "bench", "python"});
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

/// May a file of this room, or of compare/ itself where it is empty, look into that one?
bool may_look_within_compare(const std::string& path, const std::string& header) {
    const std::string room = room_in_compare(path), target = room_in_compare(header);
    const auto file_name = [](const std::string& p) { return p.substr(p.find('/') + 1); };
    if (room == target) return true;
    if (target.empty())
        return types_of_compare.contains(file_name(header)) ||
               (header == "compare/judge.h" && rooms_above_the_judge.contains(room));
    const auto& plan = room.empty() ? may_include_from_compare : may_include_in_compare;
    const auto allowed = plan.find(room.empty() ? file_name(path) : room);
    return allowed != plan.end() && allowed->second.contains(target);
}

std::string fault_within_compare(const std::string& path, const std::string& header) {
    if (!path.starts_with("compare/") || !header.starts_with("compare/")) return "";
    const std::string room = room_in_compare(path);
    if (!room.empty() && !may_include_in_compare.contains(room))
        return "compare/" + room + "/ is no room of the house";
    if (may_look_within_compare(path, header)) return "";
    const std::string from = room.empty() ? path : "compare/" + room + "/";
    return from + " may not look into " + header + " (docs/design.md, The house)";
}

struct Include {
    std::size_t line;
    bool is_own;  ///< in quotes
    std::string header;
};

std::vector<Include> includes_of(const SourceFile& file) {
    static const std::regex include{R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re"};
    std::vector<Include> found;
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        std::smatch match;
        if (std::regex_search(file.lines[i], match, include))
            found.push_back({i, match[1] == "\"", match[2]});
    }
    return found;
}

std::vector<std::string> include_faults(const SourceFile& file) {
    std::vector<std::string> faults;
    for (const auto& [line, is_own, header] : includes_of(file))
        for (const std::string& fault :
             {is_own ? fault_of_own_header(file.room, header) : fault_of_foreign_header(file.room, header),
              fault_within_compare(file.path, header)})
            if (!fault.empty()) faults.push_back(at(file, line) + fault);
    return faults;
}

/// Units, x.h and x.cpp together as "x", and the units that each looks into.
using Units = std::map<std::string, Names>;

Units units_of(const std::vector<SourceFile>& files) {
    const auto unit_of = [](const std::string& path) {
        return fs::path(path).replace_extension().generic_string();
    };
    Units units;
    for (const SourceFile& file : files)
        for (const Include& include : includes_of(file))
            if (include.is_own && unit_of(include.header) != unit_of(file.path))
                units[unit_of(file.path)].insert(unit_of(include.header));
    return units;
}

/// The shortest way from a unit back to it, "a -> b -> a"; empty where there is none.
std::string cycle_of(const std::string& unit, const Units& units) {
    std::vector<std::string> ways{unit}, ends{unit};
    Names seen;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto from = units.find(ends[i]);
        if (from == units.end()) continue;
        for (const std::string& next : from->second) {
            const std::string way = ways[i] + " -> " + next;
            if (next == unit) return way;
            if (!seen.insert(next).second) continue;
            ways.push_back(way);
            ends.push_back(next);
        }
    }
    return "";
}

/// Each named once, from the unit that comes first by name.
std::vector<std::string> cycles_among(const std::vector<SourceFile>& files) {
    Units units = units_of(files);
    std::vector<std::string> cycles;
    for (const auto& [unit, into] : Units(units)) {
        if (std::string cycle = cycle_of(unit, units); !cycle.empty()) cycles.push_back(std::move(cycle));
        units.erase(unit);
    }
    return cycles;
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

/// What whoever uses zproof compiles: the standard library, and itself.
TEST(HousePlan, ThePublicHeadersNeedTheStandardLibraryAlone) {
    const Names headers{"zproof/zproof.h", "zproof/filters.h"};
    std::size_t found = 0;
    for (const SourceFile& file : sources_in({"zproof"})) {
        if (!headers.contains(file.path)) continue;
        ++found;
        for (const Include& include : includes_of(file)) {
            const bool is_standard =
                !include.is_own && include.header.find_first_of("./") == std::string::npos;
            EXPECT_TRUE(is_standard || headers.contains(include.header))
                << file.path << ": " << include.header;
        }
    }
    EXPECT_EQ(found, headers.size());
}

TEST(HousePlan, ThePythonModuleLooksIntoThePublicHeadersAlone) {
    const Names allowed{"zproof/zproof.h", "zproof/filters.h"};
    for (const SourceFile& file : sources_in({"python"})) {
        for (const auto& [line, is_own, header] : includes_of(file)) {
            const bool may = !is_own || header.starts_with("python/") || allowed.contains(header);
            EXPECT_TRUE(may) << at(file, line) << header;
        }
    }
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

TEST(HousePlan, APlantedIncludeIsNamed) {
    const SourceFile file{
        "rasterizer/a.cpp", "rasterizer", {"// first line", "#include \"compare/judge.h\""}};
    ASSERT_EQ(include_faults(file).size(), 1u);
    EXPECT_EQ(include_faults(file)[0].find("rasterizer/a.cpp:2: rasterizer/ may not look into compare/"), 0u);
    EXPECT_EQ(include_faults({"reports/a.cpp", "reports", {"  # include <iostream>"}}).size(), 1u);
    EXPECT_EQ(include_faults({"oracle/a.cpp", "oracle", {"#include \"embree.h\""}}).size(), 1u);
    EXPECT_TRUE(include_faults({"oracle/a.cpp", "oracle", {"#include <embree3/rtcore.h>"}}).empty());
}

TEST(HousePlan, APlantedIncludeInTheJudgesRoomsIsNamed) {
    const auto faults = [](const std::string& path, const std::string& header) {
        return include_faults({path, "compare", {"#include \"" + header + "\""}}).size();
    };
    const std::string adjudicator = "compare/adjudicate/adjudicator.h", judge = "compare/judge.h";
    EXPECT_EQ(faults("compare/diagnosis/hypotheses/a.cpp", adjudicator), 0u);
    EXPECT_EQ(faults("compare/admissible/a.cpp", adjudicator), 1u);
    EXPECT_EQ(faults("compare/attic/a.cpp", adjudicator), 1u);
    EXPECT_EQ(faults("compare/diagnosis/a.h", judge), 0u);
    EXPECT_EQ(faults("compare/adjudicate/a.h", judge), 1u);
    EXPECT_EQ(faults("compare/admissible/a.h", "compare/pixel_class.h"), 0u);
    EXPECT_EQ(faults("compare/waivers/a.h", "compare/picture_difference.h"), 1u);
    EXPECT_EQ(faults("compare/judge.cpp", adjudicator), 0u);
    EXPECT_EQ(faults("compare/judge.h", adjudicator), 1u);
    EXPECT_EQ(faults("compare/finding.h", "compare/bounds/depth_bound.h"), 0u);
    EXPECT_EQ(faults("compare/finding.h", adjudicator), 1u);
    EXPECT_EQ(faults("compare/picture_difference.cpp", "compare/bounds/bounds.h"), 1u);
    EXPECT_EQ(faults("compare/picture_difference.cpp", "compare/verdict.h"), 0u);
}

TEST(HousePlan, UnitsOfTheJudgeStandInNoCycle) {
    const std::vector<std::string> cycles = cycles_among(sources_in({"compare"}));
    EXPECT_TRUE(cycles.empty()) << joined(cycles);
}

TEST(HousePlan, APlantedCycleIsNamed) {
    const auto unit = [](const std::string& path, const std::string& header) {
        return SourceFile{path, "compare", {"#include \"" + header + "\""}};
    };
    const SourceFile own = unit("compare/bounds/a.cpp", "compare/bounds/a.h"),
                     down = unit("compare/bounds/a.h", "compare/bounds/b.h"),
                     on = unit("compare/bounds/b.h", "compare/bounds/c.h"),
                     back = unit("compare/bounds/c.cpp", "compare/bounds/a.h");
    EXPECT_TRUE(cycles_among({own, down, on}).empty());
    const std::vector<std::string> cycles = cycles_among({back, own, down, on});
    ASSERT_EQ(cycles.size(), 1u);
    EXPECT_EQ(cycles[0], "compare/bounds/a -> compare/bounds/b -> compare/bounds/c -> compare/bounds/a");
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
