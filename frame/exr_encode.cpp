#include "frame/exr_encode.h"

#include <OpenEXR/openexr.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

#include "frame/deflate.h"
#include "frame/frame_error.h"
#include "frame/frame_size.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

static_assert(std::endian::native == std::endian::little,
              "OpenEXR is little-endian, and so must this machine be");

constexpr int rows_in_block = 16;  ///< what EXR_COMPRESSION_ZIP says

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
[[gnu::target_clones("default", "avx2", "avx512f")]] void predict(const char* raw, std::size_t size,
                                                                  char* missed) {
    const std::size_t half = size / 2;
    missed[0] = raw[0];
    for (std::size_t i = 1; i < half; ++i) missed[i] = static_cast<char>(raw[2 * i] - raw[2 * i - 2] + 128);
    missed[half] = static_cast<char>(raw[1] - raw[size - 2] + 128);
    for (std::size_t i = 1; i < half; ++i)
        missed[half + i] = static_cast<char>(raw[2 * i + 1] - raw[2 * i - 1] + 128);
}

/// Makes blocks, one after another, in memory of its own.
class BlockMaker {
  public:
    /// Packed, or as it is where that does not help.
    std::string block(Resolution size, std::span<const ExrChannel> channels, int first_row) {
        const auto rows = static_cast<std::size_t>(std::min(rows_in_block, size.height - first_row));
        const std::size_t row_bytes = 4 * channels.size() * static_cast<std::size_t>(size.width);
        for (std::string* buffer : {&raw_, &missed_}) buffer->resize(rows * row_bytes);
        for (std::size_t row = 0; row < rows; ++row)
            gather(size, channels, first_row + static_cast<int>(row), raw_.data() + row * row_bytes);
        predict(raw_.data(), raw_.size(), missed_.data());
        std::string packed = deflater_.deflated(missed_);
        if (packed.size() < raw_.size()) return packed;
        return raw_;
    }

  private:
    Deflater deflater_;
    std::string raw_, missed_;
};

/// OpenEXR's own writer.
class ExrWriter {
  public:
    ExrWriter(const std::filesystem::path& file, Resolution size, std::span<const ExrChannel> channels)
        : place_(file.string()), file_(file) {
        exr_context_initializer_t calls = EXR_DEFAULT_CONTEXT_INITIALIZER;
        calls.user_data = &file_;
        calls.write_fn = put;
        check(exr_start_write(&context_, place_.c_str(), EXR_WRITE_FILE_DIRECTLY, &calls));
        check(exr_add_part(context_, "frame", EXR_STORAGE_SCANLINE, &part_));
        check(exr_initialize_required_attr_simple(context_, part_, size.width, size.height,
                                                  EXR_COMPRESSION_ZIP));
        for (const ExrChannel& channel : channels)
            check(exr_add_channel(context_, part_, std::string(channel.name).c_str(),
                                  static_cast<exr_pixel_type_t>(channel.type), EXR_PERCEPTUALLY_LINEAR, 1,
                                  1));
        check(exr_write_header(context_));
    }
    ~ExrWriter() { exr_finish(&context_); }
    ExrWriter(const ExrWriter&) = delete;
    ExrWriter& operator=(const ExrWriter&) = delete;

    /// Blocks from the top, each once.
    void write(int first_row, const std::string& block) {
        check(exr_write_scanline_chunk(context_, part_, first_row, block.data(), block.size()));
    }
    /// After the last block.
    void finish() {
        check(exr_finish(&context_));
        file_.finish();
    }

  private:
    // NOLINTNEXTLINE(readability-function-size): OpenEXR asks for these parameters
    static std::int64_t put(exr_const_context_t, void* file, const void* bytes, std::uint64_t size,
                            std::uint64_t offset, exr_stream_error_func_ptr_t) {
        static_cast<WholeFile*>(file)->put(offset, {static_cast<const char*>(bytes), size});
        return static_cast<std::int64_t>(size);
    }
    void check(exr_result_t result) const {
        if (result != EXR_ERR_SUCCESS)
            throw FrameError(place_ + ": OpenEXR cannot write it: " + exr_get_default_error_message(result));
    }

    std::string place_;
    WholeFile file_;
    exr_context_t context_ = nullptr;
    int part_ = 0;
};

}  // namespace

void write_exr(const std::filesystem::path& file, Resolution size, std::span<const ExrChannel> channels) {
    assert(std::ranges::is_sorted(channels, {}, &ExrChannel::name));
    refuse_bad_size(size, file.string());
    std::vector<std::string> blocks(
        static_cast<std::size_t>((size.height + rows_in_block - 1) / rows_in_block));
    tbb::enumerable_thread_specific<BlockMaker> makers;
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
        blocks[i] = makers.local().block(size, channels, rows_in_block * static_cast<int>(i));
    });
    ExrWriter writer(file, size, channels);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        writer.write(rows_in_block * static_cast<int>(i), blocks[i]);
    writer.finish();
}

}  // namespace zproof
