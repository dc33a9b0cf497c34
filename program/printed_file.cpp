#include "program/printed_file.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "frame/frame_error.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

/// Asked before the work, which may take long.
void require_writable(const std::filesystem::path& file) {
    const auto refuse = [&](const std::string& why) {
        throw FrameError(file.string() + ": cannot be written: " + why +
                         "; expected a file name in an existing folder");
    };
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) refuse("is a folder");
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    if (::access(folder.c_str(), W_OK | X_OK) != 0) refuse(std::strerror(errno));
}

/// Is standard output a pipe whose reader has seen enough, such as `head`?
bool stdout_has_no_reader() {
    pollfd stdout_end{STDOUT_FILENO, 0, 0};
    return poll(&stdout_end, 1, 0) == 1 && (stdout_end.revents & POLLERR) != 0;
}

}  // namespace

PrintedFile::PrintedFile(const CommonArguments& common) : stdout_(std::cout.rdbuf()) {
    if (!common.is_printed_to_file()) return;
    require_writable(common.out);
    file_ = common.out;
    std::cout.rdbuf(text_.rdbuf());
}

PrintedFile::~PrintedFile() { std::cout.rdbuf(stdout_); }

void PrintedFile::finish() {
    if (!file_.empty()) return write_whole_file(file_, text_.view());
    if (!std::cout.flush() && !stdout_has_no_reader())
        throw std::runtime_error{"stdout: cannot be written; is the disk full?"};
}

}  // namespace zproof
