#include "frame/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "frame/frame_error.h"
#include "frame/input_file.h"

namespace zproof {
namespace {

/// Unique among running programs; two threads never write the same frame.
std::filesystem::path temporary_name(const std::filesystem::path& file) {
    return file.string() + "." + std::to_string(getpid()) + ".partial";
}

/// The file itself where `file` is a link to one.
std::filesystem::path replaceable(const std::filesystem::path& file) {
    std::error_code failure;
    const auto kind = std::filesystem::status(file, failure).type();
    using enum std::filesystem::file_type;
    if (kind == fifo || kind == character || kind == block || kind == socket)
        throw FrameError(file.string() +
                         ": cannot be written: is a device or a pipe; expected a regular file");
    if (kind != regular) return file;
    std::filesystem::path place = std::filesystem::canonical(file, failure);
    return failure ? file : place;
}

}  // namespace

WholeFile::WholeFile(const std::filesystem::path& file)
    : file_(replaceable(file)),
      temporary_(temporary_name(file_)),
      descriptor_(open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail();
}

WholeFile::~WholeFile() {
    if (descriptor_ >= 0) close(descriptor_);
    std::error_code ignored;
    if (!is_finished_) std::filesystem::remove(temporary_, ignored);
}

void WholeFile::fail() {
    if (failure_ == 0) failure_ = errno != 0 ? errno : EIO;
}

void WholeFile::put(std::uint64_t offset, std::string_view bytes) {
    while (failure_ == 0 && !bytes.empty()) {
        errno = 0;
        const ssize_t written = pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written <= 0) {
            if (errno != EINTR) fail();
            continue;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
        size_ = std::max(size_, offset);
    }
}

void WholeFile::take_over() {
    struct stat before {};
    if (stat(file_.c_str(), &before) != 0) return;
    errno = 0;
    if (fchmod(descriptor_, before.st_mode & 07777) != 0 || fsync(descriptor_) != 0) fail();
}

void WholeFile::finish() {
    if (failure_ == 0) take_over();
    if (descriptor_ >= 0 && close(std::exchange(descriptor_, -1)) != 0) fail();
    if (failure_ == 0) {
        std::error_code refused;
        std::filesystem::rename(temporary_, file_, refused);
        failure_ = refused.value();
        is_finished_ = !refused;
    }
    if (is_finished_) return;
    throw FrameError(file_.string() + ": cannot be written: " + std::strerror(failure_) +
                     "; expected a writable place in an existing folder");
}

void write_whole_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    write_whole_file(file, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
    WholeFile whole(file);
    whole.append(bytes);
    whole.finish();
}

std::string content_of(const std::filesystem::path& file) {
    try {
        return read_input(file, {.words = "a regular file", .most_bytes = largest_result_bytes});
    } catch (const FrameError&) {
        return {};
    }
}

}  // namespace zproof
