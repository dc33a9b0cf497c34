#include "tests/cli/same_run.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "frame/whole_file.h"
#include "tests/reports/packed_page.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

/// Every file below the folder, by its relative name.
std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator{folder})
        if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).generic_string());
    return files;
}

/// The page's script has the times too, packed: of each view, the last of its facts.
std::string with_facts_unpacked(const std::string& page) {
    const std::string begin = "id=\"facts-0\">";
    const std::size_t at = page.find(begin);
    if (at == std::string::npos) return page;
    const std::size_t first = at + begin.size(), end = page.find('<', first);
    const std::string facts =
        std::regex_replace(packed_text(page, "facts-0"), std::regex{"\"[0-9.]+\"\\]"}, "\"-\"]");
    return page.substr(0, first) + facts + page.substr(end);
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
    return std::regex_replace(with_facts_unpacked(text),
                              std::regex{"[0-9]+\\.[0-9]{2}( s</span>|</td></tr>)"}, "-$1");
}

}  // namespace

void expect_same_run(const fs::path& a, const fs::path& b) {
    ASSERT_EQ(files_in(a), files_in(b));
    for (const std::string& name : files_in(a))
        EXPECT_TRUE(without_times(content_of(a / name), name) == without_times(content_of(b / name), name))
            << name;
}

}  // namespace zproof::test
