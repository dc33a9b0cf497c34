#include "image_io/image_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "frame/frame_error.h"
#include "frame/input_file.h"
#include "image_io/module.h"
#include "image_io/samples.h"

namespace zproof::image_io {
namespace {

/// Read at once: as many rows as the largest compressed block of OpenEXR has.
constexpr int rows_at_once = 256;

/// Bytes of neighbouring channels in one pixel.
std::size_t bytes_of(const Part& part, int first, int last) {
    std::size_t sum = 0;
    for (int c = first; c < last; ++c) sum += bytes_of(part.channels[std::size_t(c)].sample);
    return sum;
}

std::vector<unsigned char> first_bytes_of(const std::filesystem::path& file) {
    std::array<char, 32> bytes{};
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), bytes.size());
    return {bytes.begin(), bytes.begin() + in.gcount()};
}

/// How many bits the grey samples of a PNG have, where they are fewer than a byte; else 0.
int scaled_bits_of_png(std::span<const unsigned char> first_bytes) {
    constexpr std::size_t bits_at = 24, colour_type_at = 25;  // ISO/IEC 15948, 11.2.2
    const bool is_grey = first_bytes.size() > colour_type_at && first_bytes[colour_type_at] == 0;
    return is_grey && first_bytes[bits_at] < 8 ? first_bytes[bits_at] : 0;
}

bool has_samples_of_no_known_type(const Part& part) {
    return std::ranges::any_of(part.channels, [](const Channel& c) { return c.sample == Sample::other; });
}

/// The first and the last but one of the rows of the data window that the display window shows.
std::pair<int, int> shown_rows(const Part& part) {
    const int top = part.display.y - part.data.y;
    return {std::clamp(top, 0, part.data.height), std::clamp(top + part.display.height, 0, part.data.height)};
}

/// The piece of row `y` of the data window that the display window shows; its count may be 0 or less.
SampleRow shown_piece(const Part& part, int y) {
    const Window &data = part.data, &display = part.display;
    const int left = std::max(data.x, display.x);
    const int right = std::min(data.x + data.width, display.x + display.width);
    const int row = data.y + y - display.y;
    return {.x = left - display.x, .y = row, .count = row < 0 || row >= display.height ? 0 : right - left};
}

/// Hands out what a block holds, row by row.
class BlockRows {
  public:
    BlockRows(const Part& part, const Block& block, std::span<const std::byte> bytes)
        : part_(part), block_(block), bytes_(bytes) {}

    void hand_to(const WantedChannel& wanted) const {
        const int channel = wanted.place.channel, first = block_.first_channel;
        const std::size_t stride = bytes_of(part_, first, first + block_.channel_count);
        for (int i = 0; i < block_.row_count; ++i) {
            SampleRow row = shown_piece(part_, block_.first_row + i);
            if (row.count <= 0) continue;
            const int skipped = row.x + part_.display.x - part_.data.x;
            const std::size_t pixel = std::size_t(i) * std::size_t(part_.data.width) + std::size_t(skipped);
            row.first = bytes_.data() + pixel * stride + bytes_of(part_, first, channel);
            row.stride = stride;
            row.sample = part_.channels[std::size_t(channel)].sample;
            wanted.take(row);
        }
    }

  private:
    const Part& part_;
    const Block& block_;
    std::span<const std::byte> bytes_;
};

}  // namespace

Format format_of(std::span<const unsigned char> first_bytes) {
    using namespace std::string_view_literals;
    constexpr std::pair<std::string_view, Format> signatures[] = {
        {"\x76\x2F\x31\x01"sv, Format::exr},
        {"II*\0"sv, Format::tiff},
        {"MM\0*"sv, Format::tiff},
        {"\x89PNG\r\n\x1A\n"sv, Format::png},
        {"\xFF\xD8\xFF"sv, Format::jpeg},
        {"PF\n"sv, Format::pfm},
        {"Pf\n"sv, Format::pfm},
        {"DDS "sv, Format::dds},
        {"\x93NUMPY"sv, Format::npy},
    };
    const std::string_view bytes(reinterpret_cast<const char*>(first_bytes.data()), first_bytes.size());
    for (const auto& [signature, format] : signatures)
        if (bytes.starts_with(signature)) return format;
    return Format::unknown;
}

Format format_of(const std::filesystem::path& file) {
    return fault_of_input(file).empty() ? format_of(first_bytes_of(file)) : Format::unknown;
}

ImageFile::ImageFile(const std::filesystem::path& file, const std::string& expected, int mip_level)
    : name_(file.string()) {
    if (const std::string fault = fault_of_input(file); !fault.empty())
        throw FrameError(name_ + ": " + fault + "; expected " + expected);
    const std::vector<unsigned char> first_bytes = first_bytes_of(file);
    format_ = format_of(first_bytes);
    if (format_ == Format::unknown)
        throw FrameError(name_ + ": not a readable OpenEXR file, nor TIFF, PNG, PFM or .npy");
    if (format_ == Format::npy)
        parts_.push_back(array_.emplace(file).part());
    else
        open({}, mip_level);
    if (format_ == Format::png) parts_[0].scaled_bits = scaled_bits_of_png(first_bytes);
}

ImageFile::ImageFile(std::span<const unsigned char> bytes, std::string name)
    : name_(std::move(name)), format_(format_of(bytes)) {
    if (format_ == Format::unknown || format_ == Format::dds || format_ == Format::npy)
        throw FrameError(name_ + ": expected a PNG or JPEG image");
    open(bytes, 0);
}

void ImageFile::open(std::span<const unsigned char> bytes, int mip_level) {
    const ModuleTable& images = module();
    try {
        file_ = {images.open({.format = format_, .path = name_, .bytes = bytes, .mip_level = mip_level}),
                 images.close};
        parts_ = images.parts(*file_);
    } catch (const std::runtime_error& e) {
        throw FrameError(name_ + ": cannot be read: " + e.what());
    }
    const auto has_no_channel = [](const Part& part) { return part.channels.empty(); };
    if (parts_.empty() || std::ranges::any_of(parts_, has_no_channel))
        throw FrameError(name_ + ": it holds no channels; expected an image");
}

const Channel& ImageFile::channel(ChannelPlace place) const {
    return parts_[std::size_t(place.part)].channels[std::size_t(place.channel)];
}

std::string ImageFile::what_it_holds() const {
    std::string all;
    for (const Part& part : parts_)
        for (const Channel& channel : part.channels)
            all += (all.empty() ? "" : ", ") + (part.name.empty() ? "" : part.name + ":") + channel.name;
    return all;
}

Resolution ImageFile::size_of(int part) const {
    const Part& p = parts_[std::size_t(part)];
    if (p.samples == Samples::deep)
        throw FrameError(name_ + ": deep samples; expected one flat value per pixel");
    const Resolution size{p.display.width, p.display.height};
    refuse_bad_size(size, name_);
    refuse_bad_size({p.data.width, p.data.height}, name_ + ": the data window");
    return size;
}

void ImageFile::refuse_scaled_samples(int part) const {
    const Part& p = parts_[std::size_t(part)];
    if (p.scaled_bits != 0)
        throw FrameError(name_ + ": " + std::to_string(p.scaled_bits) +
                         "-bit samples, which readers scale to " + name_of(p.channels[0].sample) +
                         "; expected samples of 8, 16 or 32 bits: write it so");
}

void ImageFile::read_block(const Block& block, const std::string& channel, std::span<std::byte> to) const {
    if (array_) return array_->read(block, to);
    try {
        module().read(*file_, block, to.data());
    } catch (const std::runtime_error& e) {
        throw FrameError(name_ + ": channel '" + channel + "' cannot be read: " + e.what() +
                         ", in the rows from " + std::to_string(block.first_row) + " on");
    }
}

void ImageFile::read_part(int part, std::span<const WantedChannel> channels) const {
    const Part& p = parts_[std::size_t(part)];
    if (has_samples_of_no_known_type(p)) throw FrameError(name_ + ": samples of a type that is not read");
    const auto [first, last] =
        std::ranges::minmax(channels, {}, [](const WantedChannel& wanted) { return wanted.place.channel; });
    const int count = last.place.channel - first.place.channel + 1;
    const int step = p.rows_at_once * std::max(1, rows_at_once / p.rows_at_once);
    const std::size_t row_bytes =
        std::size_t(p.data.width) * bytes_of(p, first.place.channel, first.place.channel + count);
    std::vector<std::byte> bytes(row_bytes * std::size_t(std::min(step, p.data.height)));
    const auto [first_row, end_row] = shown_rows(p);
    for (int row = first_row - first_row % step; row < end_row; row += step) {
        const Block block{part, row, std::min(step, p.data.height - row), first.place.channel, count};
        read_block(block, channel(channels.front().place).name, bytes);
        for (const WantedChannel& wanted : channels) BlockRows(p, block, bytes).hand_to(wanted);
    }
}

void ImageFile::read(std::span<const WantedChannel> channels) const {
    for (int part = 0; part < int(parts_.size()); ++part) {
        std::vector<WantedChannel> here;
        for (const WantedChannel& wanted : channels)
            if (wanted.place.part == part) here.push_back(wanted);
        if (!here.empty()) read_part(part, here);
    }
}

}  // namespace zproof::image_io
