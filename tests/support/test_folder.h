/// The one way for a test to get a place for files: a folder that nobody else has.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace zproof {

/// New and empty, below the system's folder for temporary files (TMPDIR, else /tmp); gone with this object.
class TestFolder {
  public:
    TestFolder() {
        std::string name = std::filesystem::temp_directory_path() / "zproof-test-XXXXXX";
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": no folder can be made");
        path_ = name;
    }
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file of these bytes, and the folders that it lies in.
    std::filesystem::path write(const std::filesystem::path& name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream out(file, std::ios::binary);
        out << bytes;
        if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
        return file;
    }

  private:
    std::filesystem::path path_;
};

}  // namespace zproof
