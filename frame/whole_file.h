/// Files that are there whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace zproof {

/// A file in the making: it stands under a temporary name in the same folder until it is finished, so that
/// no reader ever meets a half-written one. Where it is given up before that, nothing is left behind. A link
/// is followed; what is there and is no regular file is never replaced. What a killed process left of the
/// same file is removed.
class WholeFile {
  public:
    /// Throws FrameError where the place is a device, a pipe or a socket.
    explicit WholeFile(const std::filesystem::path& file);
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// Writes behind the farthest byte so far.
    void append(std::string_view bytes) { put(size_, bytes); }
    /// Writes at `offset` bytes from the file's beginning.
    void put(std::uint64_t offset, std::string_view bytes);
    /// Gives it its own name. A file that had it is replaced, once the new one is on the disk, and hands on
    /// its permissions. Throws FrameError where that, or anything before, failed.
    void finish();

  private:
    /// errno says why.
    void fail();

    /// What only a file that replaces another needs: its permissions, and its bytes on the disk.
    void take_over();

    std::filesystem::path file_, temporary_;
    int descriptor_;
    std::uint64_t size_ = 0;
    int failure_ = 0;  ///< errno of the first
    bool is_finished_ = false;
};

/// A whole file of these bytes, as WholeFile makes it.
void write_whole_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// All bytes of a file; empty where it cannot be read.
std::string content_of(const std::filesystem::path& file);

}  // namespace zproof
