// The words of docs/glossary.md as a test: what the field has a word for is not called by a picture of our
// own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A word in the singular, and the files, by the beginnings of their paths, in which it is the field's own.
const std::map<std::string, std::vector<std::string>> banned{
    {"accord", {}},      {"acquaintance", {}}, {"amendment", {}}, {"audience", {}}, {"comparand", {}},
    {"contestant", {}},  {"court", {}},        {"desk", {}},      {"district", {}}, {"docket", {}},
    {"easel", {}},       {"glance", {}},       {"hearing", {}},   {"inquest", {}},  {"intruder", {}},
    {"law", {}},         {"lawful", {}},       {"lens", {}},      {"nearness", {}}, {"party", {}},
    {"plaint", {}},      {"plea", {}},         {"presort", {}},   {"retrial", {}},  {"roster", {}},
    {"ruling", {}},      {"sight", {}},        {"sitting", {}},   {"stance", {}},   {"standing", {}},
    {"storyteller", {}}, {"studio", {}},       {"testimony", {}}, {"theatre", {}},  {"trick", {}},
    {"witness", {}},
};

const std::set<std::string> extensions{".h",  ".cpp", ".inl", ".md",    ".py",
                                       ".ts", ".mjs", ".txt", ".cmake", ".json"};
/// Not ours, made by programs, or about these words.
const std::set<std::string> passed_over{"build",
                                        ".git",
                                        "node_modules",
                                        "dist",
                                        "blender_render.py",  // Blender's own names
                                        "LICENSE",
                                        "vocabulary_test.cpp",
                                        "package-lock.json",
                                        "zproof-out",
                                        "CHANGELOG.md"};

/// The words of a line in lower case: identifiers are taken apart at '_' and before capitals.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto c = static_cast<unsigned char>(line[i]);
        const bool begins = std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(line[i - 1]));
        if (!std::isalpha(c) || begins) words.emplace_back();
        if (std::isalpha(c)) words.back().push_back(char(std::tolower(c)));
    }
    std::erase_if(words, [](const std::string& word) { return word.empty(); });
    return words;
}

std::vector<std::string> singulars_of(const std::string& word) {
    std::vector<std::string> forms{word};
    if (word.ends_with("ies")) forms.push_back(word.substr(0, word.size() - 3) + "y");
    if (word.ends_with("es")) forms.push_back(word.substr(0, word.size() - 2));
    if (word.ends_with("s")) forms.push_back(word.substr(0, word.size() - 1));
    return forms;
}

/// The banned word that this one is, or nothing.
std::string banned_word(const std::string& word, const std::string& path) {
    for (const std::string& form : singulars_of(word)) {
        const auto found = banned.find(form);
        if (found == banned.end()) continue;
        const auto& allowed_in = found->second;
        const auto is_beginning = [&](const std::string& beginning) { return path.starts_with(beginning); };
        if (std::ranges::none_of(allowed_in, is_beginning)) return form;
    }
    return "";
}

std::vector<std::string> banned_words(std::istream& text, const std::string& path) {
    std::vector<std::string> found;
    int number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        for (const std::string& word : words_of(line))
            if (const std::string is = banned_word(word, path); !is.empty())
                found.push_back(path + ":" + std::to_string(number) + ": " + is);
    }
    return found;
}

std::vector<fs::path> texts() {
    std::vector<fs::path> files;
    for (auto it = fs::recursive_directory_iterator{ZPROOF_SOURCE_DIR};
         it != fs::recursive_directory_iterator{}; ++it) {
        const fs::path& path = it->path();
        if (passed_over.contains(path.filename().string())) {
            it.disable_recursion_pending();
        } else if (it->is_regular_file() && extensions.contains(path.extension().string())) {
            files.push_back(path);
        }
    }
    return files;
}

TEST(Vocabulary, IsTheFields) {
    const std::vector<fs::path> files = texts();
    EXPECT_GT(files.size(), 500u);
    for (const fs::path& file : files) {
        std::ifstream in{file};
        const std::string path = fs::relative(file, ZPROOF_SOURCE_DIR).generic_string();
        for (const std::string& found : banned_words(in, path + " ")) ADD_FAILURE() << found;
        std::istringstream name{path};
        for (const std::string& found : banned_words(name, path)) ADD_FAILURE() << "name of " << found;
    }
}

TEST(Vocabulary, PlantedPicturesAreFoundInIdentifiersAndProse) {
    for (const std::string line : {"struct LawMaker {};", "int first_sight = 0;", "// The witnesses agree.",
                                   "\"Parties\"", "class Testimony;"}) {
        std::istringstream in{line};
        EXPECT_EQ(banned_words(in, "planted.h").size(), 1u) << line;
    }
    std::istringstream clean{"flaws outlaw insight understanding third_partial desktop"};
    EXPECT_TRUE(banned_words(clean, "planted.h").empty());
}

}  // namespace
