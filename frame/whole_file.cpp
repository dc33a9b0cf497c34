#include "frame/whole_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "frame/frame_error.h"
#include "frame/input_file.h"

namespace zproof {
namespace {

/// Unique among running programs; two threads never write the same frame.
std::filesystem::path temporary_name(const std::filesystem::path& file) {
    return file.string() + "." + std::to_string(getpid()) + ".partial";
}

/// Is it temporary_name(file), of any process?
bool is_temporary(const std::filesystem::path& name, const std::filesystem::path& file) {
    const std::string text = name.filename().string(), begin = file.filename().string() + ".",
                      end = ".partial";
    if (!text.starts_with(begin) || !text.ends_with(end)) return false;
    return text.find_first_not_of("0123456789", begin.size()) == text.size() - end.size();
}

/// Removes the temporary file of a process that is gone: no one holds its lock.
void remove_if_left(const std::filesystem::path& temporary) {
    const int descriptor = open(temporary.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(temporary.c_str());
    close(descriptor);
}

void remove_what_was_left(const std::filesystem::path& file) {
    std::error_code failure;
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    for (auto i = std::filesystem::directory_iterator(folder, failure); !failure && i != end(i);
         i.increment(failure))
        if (is_temporary(i->path(), file)) remove_if_left(i->path());
}

/// Locked until it is closed, where the file system has locks. One that was taken for a left one between
/// both calls is opened again.
int open_locked(const std::filesystem::path& temporary) {
    for (;;) {
        const int descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        if (descriptor < 0) return descriptor;
        while (flock(descriptor, LOCK_EX) != 0 && errno == EINTR) continue;
        struct stat opened {};
        if (fstat(descriptor, &opened) != 0 || opened.st_nlink > 0) return descriptor;
        close(descriptor);
    }
}

/// As open_locked(), and first what others left is removed.
int open_alone(const std::filesystem::path& temporary, const std::filesystem::path& file) {
    remove_what_was_left(file);
    errno = 0;
    return open_locked(temporary);
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
      descriptor_(open_alone(temporary_, file_)) {
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
