// Runs a harness on files, and on every file of folders: the corpora and the regressions in an ordinary
// build.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "tests/fuzz/harness.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& named) {
    if (!fs::is_directory(named)) return {named};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(named)) files.push_back(entry.path());
    return files;
}

void replay(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in) throw std::runtime_error("cannot be read");
    std::cout << file.string() << std::endl;  // a crash is that of the last file named
    zproof::fuzz::read_input({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

}  // namespace

int main(int argc, char** argv) {
    int failed = 0, count = 0;
    for (int i = 1; i < argc; ++i)
        for (const fs::path& file : files_in(argv[i])) try {
                ++count;
                replay(file);
            } catch (const std::exception& error) {
                std::cout << file.string() << ": " << error.what() << "\n";
                failed = 1;
            }
    std::cout << count << " inputs\n";
    return count == 0 ? 1 : failed;
}
