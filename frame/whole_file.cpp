#include "frame/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "frame/frame_error.h"

namespace zproof {
namespace {

/// Unique among running programs; two threads never write the same frame.
std::filesystem::path temporary_name(const std::filesystem::path& file) {
    return file.string() + "." + std::to_string(getpid()) + ".partial";
}

/// errno of the first failure, 0 where all went well.
int write_bytes(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    errno = 0;
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out) return 0;
    return errno != 0 ? errno : EIO;
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    const std::filesystem::path temporary = temporary_name(file);
    int failure = write_bytes(temporary, bytes);
    if (failure == 0) {
        std::error_code refused;
        std::filesystem::rename(temporary, file, refused);
        failure = refused.value();
    }
    if (failure == 0) return;
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw FrameError(file.string() + ": cannot be written: " + std::strerror(failure) +
                     "; expected a writable place in an existing folder");
}

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
    write_whole_file(file, std::as_bytes(std::span{bytes}));
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
