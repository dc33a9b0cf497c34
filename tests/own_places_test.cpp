// Tests run side by side. What one of them writes, no other may meet: places for files come from one class,
// or from the like of Python, node and the shell, and nothing has a fixed name in a folder that all can see.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

/// Where such words must stand: the class itself, and this file.
const std::set<std::string> exempt{"tests/support/test_folder.h", "tests/own_places_test.cpp"};

/// By the ends of files' names: what makes a place that is shared, or a second way to a place of one's own.
const std::map<std::string, std::regex>& shared_places() {
    static const std::regex cpp{
        R"(\bTempDir\(|temp_directory_path|\bmk[ds]temp|\btmpn?am|\btmpfile|"/tmp\b|/dev/shm)"};
    static const std::regex python{
        R"(gettempdir|\bmktemp\(|['"]/tmp\b|/dev/shm|(127\.0\.0\.1|localhost)['"]?[:,] ?[1-9])"};
    static const std::regex node{
        R"(mkdtempSync\((?!join\(tmpdir\(\))|['"`]/tmp\b|/dev/shm|listen\([1-9]|localhost:[1-9])"};
    static const std::regex shell{R"(/tmp/|/dev/shm)"};
    static const std::map<std::string, std::regex> of_kind{{".cpp", cpp},   {".h", cpp},    {".inl", cpp},
                                                           {".py", python}, {".mjs", node}, {".sh", shell}};
    return of_kind;
}

/// "tests/a.cpp:3: TempDir()"; empty where the line names no such place.
std::string fault_of(const std::string& path, std::size_t line, const std::string& text) {
    const auto kind = shared_places().find(fs::path{path}.extension());
    std::smatch match;
    if (kind == shared_places().end() || !std::regex_search(text, match, kind->second)) return "";
    return path + ":" + std::to_string(line) + ": " + match.str() +
           " is shared by all tests; take a folder of the test's own (tests/support/test_folder.h)";
}

TEST(OwnPlaces, NoTestWritesWhereAnotherMay) {
    const fs::path root = ZPROOF_SOURCE_DIR;
    std::size_t files = 0;
    for (const char* folder : {"tests", "python/tests", "bench"})
        for (const auto& entry : fs::recursive_directory_iterator{root / folder}) {
            const std::string path = fs::relative(entry.path(), root).generic_string();
            if (!shared_places().contains(entry.path().extension()) || exempt.contains(path)) continue;
            ++files;
            std::ifstream in{entry.path()};
            std::size_t number = 0;
            for (std::string line; std::getline(in, line);) EXPECT_EQ(fault_of(path, ++number, line), "");
        }
    EXPECT_GT(files, 300u);
}

TEST(OwnPlaces, APlantedNameIsFound) {
    for (const auto& [path, line] : std::map<std::string, std::string>{
             {"a.cpp", R"(std::string file = testing::TempDir() + "labels.json";)"},
             {"b.h", "fs::temp_directory_path() / \"x\""},
             {"c.cpp", R"(std::ofstream("/tmp/x");)"},
             {"d.py", "open('/tmp/x', 'w')"},
             {"e.py", "server.bind(('127.0.0.1', 8080))"},
             {"f.mjs", "mkdtempSync('/tmp/x')"},
             {"g.sh", "cp a /tmp/b"}})
        EXPECT_EQ(fault_of(path, 7, line).rfind(path + ":7: ", 0), 0u) << path;
    for (const auto& [path, line] :
         std::map<std::string, std::string>{{"a.cpp", "const TestFolder folder;"},
                                            {"d.py", "folder = tempfile.mkdtemp(prefix='x')"},
                                            {"e.py", "server.bind(('127.0.0.1', 0))"},
                                            {"f.mjs", "mkdtempSync(join(tmpdir(), 'x'))"},
                                            {"g.sh", "place=$(mktemp -d)"}})
        EXPECT_EQ(fault_of(path, 7, line), "");
}

}  // namespace
