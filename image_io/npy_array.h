/// An array that numpy.save wrote: one image, whose channels are called 0, 1, 2 and so on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "image_io/module_table.h"

namespace zproof::image_io {

/// Shapes that are read: (height, width), (height, width, channels) and (1, height, width, channels).
class NpyArray {
  public:
    /// Reads the header. Throws FrameError where it is no such array, where its samples do not lie row by row
    /// in little-endian order, and where the file holds more or fewer bytes than the header says.
    explicit NpyArray(const std::filesystem::path& file);

    const Part& part() const { return part_; }
    /// The samples of a block, packed. Throws FrameError where they cannot be read.
    void read(const Block& block, std::span<std::byte> to) const;

  private:
    std::filesystem::path file_;
    Part part_;
    std::uint64_t first_sample_ = 0;  ///< bytes from the file's beginning
};

}  // namespace zproof::image_io
