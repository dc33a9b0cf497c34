#include "frame/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "frame/frame_error.h"

namespace zproof {
namespace {

/// Unique among running programs; two threads never write the same frame.
std::filesystem::path temporary_name(const std::filesystem::path& file) {
    return file.string() + "." + std::to_string(getpid()) + ".partial";
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path file)
    : file_(std::move(file)),
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

void WholeFile::finish() {
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
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(file, unknown);
    std::ifstream in(file, std::ios::binary);
    if (unknown || !in) return {};
    std::string content(size, '\0');
    in.read(content.data(), static_cast<std::streamsize>(size));
    content.resize(static_cast<std::size_t>(in.gcount()));
    return content;
}

}  // namespace zproof
