/// OpenEXR files as planes of 32-bit values, whoever wrote them: scanlines or tiles, any compression, any
/// number of channels and parts, of which the first is read.
#pragma once

#include <OpenEXR/openexr.h>

#include <filesystem>
#include <span>
#include <string>

#include "frame/exr_encode.h"
#include "frame/plane.h"

namespace zproof {

/// A channel that the file must have, and where its values go: row-major, `stride` bytes from one pixel to
/// the next.
struct WantedChannel {
    std::string name;
    ExrType type = ExrType::float32;
    void* first = nullptr;
    std::size_t stride = 4;
};

/// An open OpenEXR file whose first part is flat and shows every pixel.
class ExrReader {
  public:
    /// Throws FrameError, naming the file, where it is not one, is deep, or has no data for some pixels.
    explicit ExrReader(const std::filesystem::path& file);
    ~ExrReader() { exr_finish(&context_); }
    ExrReader(const ExrReader&) = delete;
    ExrReader& operator=(const ExrReader&) = delete;

    Resolution size() const { return size_; }
    /// Fills in all pixels of the channels, bit for bit, on the threads of the surrounding tbb::task_arena.
    /// Throws FrameError, naming file and channel, where one is missing, is of another type, leaves pixels
    /// out, or cannot be read.
    void read(std::span<const WantedChannel> channels) const;

  private:
    class BlockReader;

    void refuse_unusual_layout();
    void require(const WantedChannel& wanted) const;
    std::string what_it_holds() const;
    void check(exr_result_t result) const;
    bool is_tiled() const;

    std::string name_;
    exr_context_t context_ = nullptr;
    Resolution size_;
    int left_ = 0, top_ = 0;  ///< of the data window
};

}  // namespace zproof
