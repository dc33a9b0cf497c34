#include "frame/exr_encode.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <numeric>
#include <utility>
#include <vector>

#include "frame/deflate.h"
#include "frame/frame_size.h"

namespace zproof {
namespace {

static_assert(std::endian::native == std::endian::little,
              "OpenEXR is little-endian, and so must this machine be");

constexpr int rows_in_block = 16;  ///< what ZIP_COMPRESSION says
constexpr std::uint8_t zip_compression = 3, increasing_y = 0;

template <class T>
std::string bits_of(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

template <class... T>
std::string joined(const T&... values) {
    return (bits_of(values) + ...);
}

std::string zero_ended(std::string_view text) { return std::string(text) + '\0'; }

std::string attribute(std::string_view name, std::string_view type, const std::string& value) {
    return zero_ended(name) + zero_ended(type) + bits_of(static_cast<std::int32_t>(value.size())) + value;
}

std::string channel_list(std::span<const ExrChannel> channels) {
    std::string list;
    for (const ExrChannel& channel : channels)
        list += zero_ended(channel.name) +
                joined(channel.type, std::uint32_t{0}, std::int32_t{1}, std::int32_t{1});
    return list + '\0';
}

std::string header(Resolution size, std::span<const ExrChannel> channels) {
    const std::string window = joined(std::int32_t{0}, std::int32_t{0}, size.width - 1, size.height - 1);
    return joined(std::uint32_t{20000630}, std::uint32_t{2}) +  // magic number, version
           attribute("channels", "chlist", channel_list(channels)) +
           attribute("compression", "compression", bits_of(zip_compression)) +
           attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) +
           attribute("lineOrder", "lineOrder", bits_of(increasing_y)) +
           attribute("pixelAspectRatio", "float", bits_of(1.0f)) +
           attribute("screenWindowCenter", "v2f", joined(0.0f, 0.0f)) +
           attribute("screenWindowWidth", "float", bits_of(1.0f)) + '\0';
}

/// Row by row, and within a row channel by channel.
void gather(Resolution size, std::span<const ExrChannel> channels, int row, char* to) {
    for (const ExrChannel& channel : channels) {
        const auto width = static_cast<std::size_t>(size.width);
        const char* from =
            static_cast<const char*>(channel.first) + static_cast<std::size_t>(row) * width * channel.stride;
        if (channel.stride == 4) std::memcpy(to, from, 4 * width);
        for (std::size_t x = 0; channel.stride != 4 && x < width; ++x)
            std::memcpy(to + 4 * x, from + x * channel.stride, 4);
        to += 4 * width;
    }
}

/// Even bytes, then odd ones; and of those each less the one before it, plus 128 (but for the first).
void predict(std::string_view raw, std::string& sorted_bytes, std::string& missed_bytes) {
    assert(raw.size() % 2 == 0 && sorted_bytes.size() == raw.size() && missed_bytes.size() == raw.size());
    const std::size_t half = raw.size() / 2;
    // Bare pointers: a char written through the strings might be their own pointer, for all the compiler
    // knows.
    const char* from = raw.data();
    char *sorted = sorted_bytes.data(), *missed = missed_bytes.data();
    for (std::size_t i = 0; i < half; ++i) sorted[i] = from[2 * i];
    for (std::size_t i = 0; i < half; ++i) sorted[half + i] = from[2 * i + 1];
    missed[0] = sorted[0];
    for (std::size_t i = 1; i < 2 * half; ++i) missed[i] = static_cast<char>(sorted[i] - sorted[i - 1] + 128);
}

/// Makes blocks, one after another, in memory of its own.
class BlockMaker {
  public:
    /// First row, length, content: packed, or as it is where that does not help.
    std::string block(Resolution size, std::span<const ExrChannel> channels, int first_row) {
        const auto rows = static_cast<std::size_t>(std::min(rows_in_block, size.height - first_row));
        const std::size_t row_bytes = 4 * channels.size() * static_cast<std::size_t>(size.width);
        for (std::string* buffer : {&raw_, &sorted_, &missed_}) buffer->resize(rows * row_bytes);
        for (std::size_t row = 0; row < rows; ++row)
            gather(size, channels, first_row + static_cast<int>(row), raw_.data() + row * row_bytes);
        predict(raw_, sorted_, missed_);
        const std::string packed = deflater_.deflated(missed_);
        const std::string& content = packed.size() < raw_.size() ? packed : raw_;
        return joined(first_row, static_cast<std::int32_t>(content.size())) + content;
    }

  private:
    Deflater deflater_;
    std::string raw_, sorted_, missed_;
};

}  // namespace

std::string encode_exr(Resolution size, std::span<const ExrChannel> channels, const std::string& place) {
    assert(std::ranges::is_sorted(channels, {}, &ExrChannel::name));
    refuse_bad_size(size, place);
    std::vector<std::string> blocks(
        static_cast<std::size_t>((size.height + rows_in_block - 1) / rows_in_block));
    tbb::enumerable_thread_specific<BlockMaker> makers;
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        blocks[i] = makers.local().block(size, channels, rows_in_block * static_cast<int>(i));
    });
    std::string file = header(size, channels);
    std::uint64_t at = file.size() + sizeof at * blocks.size();
    file.reserve(
        std::accumulate(blocks.begin(), blocks.end(), std::size_t{at},
                        [](std::size_t sum, const std::string& block) { return sum + block.size(); }));
    for (const std::string& block : blocks) file += bits_of(std::exchange(at, at + block.size()));
    for (const std::string& block : blocks) file += block;
    return file;
}

}  // namespace zproof
