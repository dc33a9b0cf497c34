/// A folder for readers that take a file. `./dev fuzz` keeps it in memory (TMPDIR).
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "tests/fuzz/harness.h"

namespace zproof::fuzz {

class ScratchFolder {
  public:
    ScratchFolder() { std::filesystem::create_directories(path_); }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes a file of these bytes.
    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        std::ofstream out(path_ / name, std::ios::binary);
        out << bytes;
        require(bool(out.flush()), "the scratch folder can be written to");
        return path_ / name;
    }
    std::filesystem::path write(const std::string& name, Input bytes) const {
        return write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("zproof_fuzz_" + std::to_string(getpid()));
};

}  // namespace zproof::fuzz
