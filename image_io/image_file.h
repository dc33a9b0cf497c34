/// An image file that is open for reading: through the module, or numpy's .npy.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frame/plane.h"
#include "image_io/module_table.h"
#include "image_io/npy_array.h"

namespace zproof::image_io {

/// The format that the first bytes name; `unknown` for any other file.
Format format_of(std::span<const unsigned char> first_bytes);
/// The same of a file; `unknown` where it cannot be read.
Format format_of(const std::filesystem::path& file);

/// Samples of one channel: the pixels from (x, y) of the display window to the right, `stride` bytes apart.
struct SampleRow {
    int x = 0, y = 0;
    int count = 0;
    const std::byte* first = nullptr;
    std::size_t stride = 0;
    Sample sample = Sample::other;
};

struct ChannelPlace {
    int part = 0, channel = 0;
};

/// A channel to be read. `take` is called for every row in which the data and display windows meet.
struct WantedChannel {
    ChannelPlace place;
    std::function<void(const SampleRow&)> take;
};

class ImageFile {
  public:
    /// Opens a file and reads the headers of that mip level. Throws FrameError where it is missing, of no
    /// known format, or broken. `expected` ends the sentence about a missing file: "an OpenEXR frame".
    ImageFile(const std::filesystem::path& file, const std::string& expected, int mip_level = 0);
    /// Opens a file in memory. `name` stands for it in errors.
    ImageFile(std::span<const unsigned char> bytes, std::string name);

    const std::string& name() const { return name_; }
    Format format() const { return format_; }
    const std::vector<Part>& parts() const { return parts_; }
    const Channel& channel(ChannelPlace place) const;
    /// "R, G, B": the channels of all parts; "left:Z, right:Z" where the parts have names.
    std::string what_it_holds() const;

    /// The size of a part's display window. Throws FrameError for deep samples, and where the size of either
    /// window is not allowed.
    Resolution size_of(int part) const;
    /// Throws FrameError where reading scales the samples: of ids and depths nothing would be left.
    void refuse_scaled_samples(int part) const;
    /// Reads the samples of some channels that the display window shows. Throws FrameError, naming the
    /// channel, where they cannot be read.
    void read(std::span<const WantedChannel> channels) const;

  private:
    void open(std::span<const unsigned char> bytes, int mip_level);
    void read_part(int part, std::span<const WantedChannel> channels) const;
    void read_block(const Block& block, const std::string& channel, std::span<std::byte> to) const;

    std::string name_;
    Format format_ = Format::unknown;
    std::unique_ptr<OpenFile, void (*)(OpenFile*)> file_{nullptr, nullptr};
    std::optional<NpyArray> array_;
    std::vector<Part> parts_;
};

}  // namespace zproof::image_io
