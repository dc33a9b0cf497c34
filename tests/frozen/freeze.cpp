// Freezes what the judge says, so that another judge can be held against it.
//
//     freeze [GROUP]...                  a line per subject, as in frozen.txt (record.h)
//     freeze --into FOLDER [GROUP]...    the same, and whole texts into FOLDER/GROUP/NAME.txt
//     freeze --text GROUP NAME           the whole text of one subject
//
// No group: all (tests/frozen/subjects.h).
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/frozen/record.h"
#include "tests/frozen/subjects.h"

namespace {

using namespace zproof::frozen;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

/// An empty folder: texts are not written.
void freeze(const std::string& group, const fs::path& folder) {
    each_subject({group}, [&](const Subject& subject) {
        const VerdictText text = judged_text(subject);
        std::cout << line_of(record_of(subject, text)) << std::flush;
        if (!folder.empty()) write(folder / group / (subject.name + ".txt"), text.both());
    });
}

void print_text(const std::string& group, const std::string& name) {
    each_subject({group, name}, [](const Subject& subject) { std::cout << judged_text(subject).both(); });
}

void run(Words words) {
    if (words.size() == 3 && words[0] == "--text") return print_text(words[1], words[2]);
    fs::path folder;
    if (words.size() >= 2 && words[0] == "--into") {
        folder = words[1];
        words.erase(words.begin(), words.begin() + 2);
    }
    if (words.empty()) words.assign(groups().begin(), groups().end());
    for (const std::string& group : words) freeze(group, folder);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run({argv + 1, argv + argc});
    } catch (const std::exception& e) {
        std::cerr << "freeze: " << e.what() << '\n';
        return 2;
    }
}
