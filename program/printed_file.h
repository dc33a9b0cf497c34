/// -o of a command that prints: a file takes what stdout would have shown.
#pragma once

#include <filesystem>
#include <sstream>

#include "program/common_arguments.h"

namespace zproof {

/// While it lives, what is printed on std::cout is kept for the file, if one is named. Nothing is written
/// before finish(): a command that is refused leaves the file as it was.
class PrintedFile {
  public:
    /// Throws FrameError where it is plain that no such file can be written.
    explicit PrintedFile(const CommonArguments& common);
    ~PrintedFile();
    PrintedFile(const PrintedFile&) = delete;
    PrintedFile& operator=(const PrintedFile&) = delete;

    /// Writes the file, or what is on its way to stdout. Throws std::runtime_error where that fails.
    void finish();

  private:
    std::filesystem::path file_;  ///< empty: stdout itself
    std::ostringstream text_;
    std::streambuf* stdout_;
};

}  // namespace zproof
