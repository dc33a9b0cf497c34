#include "frame/exr_decode.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "frame/frame_error.h"
#include "frame/frame_size.h"

namespace zproof {
namespace {

constexpr int part = 0;

/// OpenEXR's own names.
const char* name_of(int type) {
    constexpr const char* names[] = {"uint", "half", "float"};
    return names[type];
}

/// A library's error messages go where its caller's exceptions go, not to stderr.
void keep_quiet(exr_const_context_t, exr_result_t, const char*) {}

std::string reason_of(exr_result_t result) { return exr_get_default_error_message(result); }

std::span<const exr_attr_chlist_entry_t> channels_of(exr_const_context_t context) {
    const exr_attr_chlist_t* list = nullptr;
    if (exr_get_channels(context, part, &list) != EXR_ERR_SUCCESS) return {};
    return {list->entries, std::size_t(list->num_channels)};
}

const exr_attr_chlist_entry_t* find_channel(exr_const_context_t context, const std::string& name) {
    for (const exr_attr_chlist_entry_t& channel : channels_of(context))
        if (channel.name.str == name) return &channel;
    return nullptr;
}

}  // namespace

/// Reads blocks one after another, in memory of its own.
class ExrReader::BlockReader {
  public:
    BlockReader(const ExrReader& file, std::span<const WantedChannel> channels)
        : file_(file), channels_(channels) {}
    ~BlockReader() { exr_decoding_destroy(file_.context_, &pipeline_); }
    BlockReader(const BlockReader&) = delete;
    BlockReader& operator=(const BlockReader&) = delete;

    /// The block's first pixel, counted from the image's upper left corner.
    struct Corner {
        int x, y;
    };
    void read(const exr_chunk_info_t& block, const Corner& corner) {
        check(prepare(block), corner);
        for (int i = 0; i < pipeline_.channel_count; ++i) direct(pipeline_.channels[i], corner);
        check(exr_decoding_choose_default_routines(file_.context_, part, &pipeline_), corner);
        check(exr_decoding_run(file_.context_, part, &pipeline_), corner);
    }
    void check(exr_result_t result, const Corner& corner) const {
        if (result == EXR_ERR_SUCCESS) return;
        throw FrameError(file_.name_ + ": channel '" + channels_.front().name +
                         "' cannot be read: " + reason_of(result) + ", in the block of pixel (" +
                         std::to_string(corner.x) + ", " + std::to_string(corner.y) + ")");
    }

  private:
    exr_result_t prepare(const exr_chunk_info_t& block) {
        const auto prepare = pipeline_.context ? exr_decoding_update : exr_decoding_initialize;
        return prepare(file_.context_, part, &block, &pipeline_);
    }
    /// Where the block's values of a channel go; nowhere for one that nobody wants.
    void direct(exr_coding_channel_info_t& channel, const Corner& corner) const {
        channel.decode_to_ptr = nullptr;
        for (const WantedChannel& wanted : channels_) {
            if (wanted.name != channel.channel_name) continue;
            const std::size_t line = wanted.stride * std::size_t(file_.size_.width);
            channel.user_pixel_stride = std::int32_t(wanted.stride);
            channel.user_line_stride = std::int32_t(line);
            channel.decode_to_ptr = static_cast<std::uint8_t*>(wanted.first) + std::size_t(corner.y) * line +
                                    std::size_t(corner.x) * wanted.stride;
        }
    }

    const ExrReader& file_;
    std::span<const WantedChannel> channels_;
    exr_decode_pipeline_t pipeline_{};
};

ExrReader::ExrReader(const std::filesystem::path& file) : name_(file.string()) {
    if (!std::filesystem::is_regular_file(file))
        throw FrameError(name_ + ": no such file; expected an OpenEXR frame");
    exr_context_initializer_t calls = EXR_DEFAULT_CONTEXT_INITIALIZER;
    calls.error_handler_fn = keep_quiet;
    const exr_result_t result = exr_start_read(&context_, name_.c_str(), &calls);
    if (result != EXR_ERR_SUCCESS) {
        exr_finish(&context_);
        throw FrameError(name_ + ": not a readable OpenEXR file: " + reason_of(result));
    }
    try {
        refuse_unusual_layout();
    } catch (...) {
        exr_finish(&context_);
        throw;
    }
}

void ExrReader::check(exr_result_t result) const {
    if (result != EXR_ERR_SUCCESS)
        throw FrameError(name_ + ": not a readable OpenEXR file: " + reason_of(result));
}

void ExrReader::refuse_unusual_layout() {
    exr_storage_t storage = EXR_STORAGE_SCANLINE;
    check(exr_get_storage(context_, part, &storage));
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
        throw FrameError(name_ + ": deep samples; expected one flat value per pixel");
    exr_attr_box2i_t here{}, shown{};
    check(exr_get_data_window(context_, part, &here));
    check(exr_get_display_window(context_, part, &shown));
    left_ = here.min.x, top_ = here.min.y;
    size_ = {here.max.x - here.min.x + 1, here.max.y - here.min.y + 1};
    refuse_bad_size(size_, name_);
    const bool whole = here.min.x == shown.min.x && here.min.y == shown.min.y && here.max.x == shown.max.x &&
                       here.max.y == shown.max.y;
    if (!whole) throw FrameError(name_ + ": the data window is not the display window; write every pixel");
}

std::string ExrReader::what_it_holds() const {
    std::string all;
    for (const exr_attr_chlist_entry_t& channel : channels_of(context_))
        all += (all.empty() ? "" : ", ") + std::string(channel.name.str);
    return all;
}

void ExrReader::require(const WantedChannel& wanted) const {
    const exr_attr_chlist_entry_t* channel = find_channel(context_, wanted.name);
    if (!channel)
        throw FrameError(name_ + ": channel '" + wanted.name + "' is missing; the file holds " +
                         what_it_holds());
    if (int(channel->pixel_type) != int(wanted.type))
        throw FrameError(name_ + ": channel '" + wanted.name + "' is of type " +
                         name_of(channel->pixel_type) + "; expected " + name_of(int(wanted.type)));
    if (channel->x_sampling != 1 || channel->y_sampling != 1)
        throw FrameError(name_ + ": channel '" + wanted.name + "' has a value for every " +
                         std::to_string(channel->x_sampling) + " x " + std::to_string(channel->y_sampling) +
                         " pixels; write every pixel");
}

bool ExrReader::is_tiled() const {
    exr_storage_t storage = EXR_STORAGE_SCANLINE;
    check(exr_get_storage(context_, part, &storage));
    return storage == EXR_STORAGE_TILED;
}

void ExrReader::read(std::span<const WantedChannel> channels) const {
    for (const WantedChannel& wanted : channels) require(wanted);
    std::int32_t width = size_.width, height = 0;  // of a block
    const bool tiled = is_tiled();
    check(tiled ? exr_get_tile_sizes(context_, part, 0, 0, &width, &height)
                : exr_get_scanlines_per_chunk(context_, part, &height));
    const int across = (size_.width + width - 1) / width, down = (size_.height + height - 1) / height;
    tbb::enumerable_thread_specific<BlockReader> readers([&] { return BlockReader(*this, channels); });
    tbb::parallel_for(0, across * down, [&](int i) {
        const int column = i % across, row = i / across;
        const BlockReader::Corner corner{column * width, row * height};
        BlockReader& reader = readers.local();
        exr_chunk_info_t block{};
        reader.check(tiled ? exr_read_tile_chunk_info(context_, part, column, row, 0, 0, &block)
                           : exr_read_scanline_chunk_info(context_, part, top_ + corner.y, &block),
                     corner);
        reader.read(block, corner);
    });
}

}  // namespace zproof
