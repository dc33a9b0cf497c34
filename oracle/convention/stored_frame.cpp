#include "oracle/convention/stored_frame.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>

#include "frame/frame_error.h"
#include "frame/number_text.h"
#include "image_io/image_io.h"
#include "image_io/module.h"
#include "image_io/raw_frame.h"
#include "math/srgb.h"
#include "oracle/convention/frame_bytes.h"
#include "oracle/isolated.h"
#include "scenes/camera_depth.h"

namespace zproof::oracle {

namespace {

namespace fs = std::filesystem;

Frame frame_of(const RawFrame& raw, const Convention& convention, const View& view, IdChannel ids) {
    const bool has_ids = ids == IdChannel::present;
    if (has_ids && !raw.primitive) throw FrameError(raw.why_no_ids);
    const CameraDepth camera_depth(convention, view);
    Frame frame({view.width, view.height});
    frame.attributes = raw.attributes;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const double stored = raw.stored_depth.at(x, y);
            const bool says_background = camera_depth.is_background(stored);
            PrimitiveId& id = frame.primitive.at(x, y) =
                has_ids ? raw.primitive->at(x, y) : PrimitiveId::none;
            if (convention.background_by == BackgroundBy::depth && says_background) id = PrimitiveId::none;
            // Where the file has no data, the raw depth is +infinity.
            const bool is_background =
                id == PrimitiveId::none && (says_background || stored == double(background_depth));
            frame.camera_depth.at(x, y) =
                is_background ? background_depth : float(camera_depth(stored, x, y));
        }
    return frame;
}

/// All that is made of a pixel on the way: ids, depths in double, attributes, and a copy of them.
constexpr std::size_t most_bytes_per_pixel = 160;

Resolution size_of(const fs::path& file, const Convention& convention, IdChannel ids) {
    return convention == Convention{} ? frame_size(file, ids) : raw_frame_size(file, convention);
}

/// The size is compared before anything of it is allocated.
Frame read_here(const fs::path& file, const Convention& convention, const View& view, IdChannel ids) {
    refuse_other_size(file, size_of(file, convention, ids), view);
    if (convention == Convention{}) return read_frame(file, ids);  // bit for bit
    return frame_of(read_raw_frame(file, convention), convention, view, ids);
}

}  // namespace

Frame read_stored_frame(const fs::path& file, const Convention& convention, const View& view, IdChannel ids,
                        std::chrono::milliseconds time_limit) {
    const std::size_t pixels = Resolution{view.width, view.height}.pixel_count();
    image_io::load_module_for(file);
    const Bytes bytes =
        isolated(file.string(), {reader_memory_bytes + most_bytes_per_pixel * pixels, time_limit},
                 [&] { return bytes_of(read_here(file, convention, view, ids)); });
    return frame_from(bytes, file.string());
}

Resolution stored_frame_size(const fs::path& file, const Convention& convention, IdChannel ids,
                             std::chrono::milliseconds time_limit) {
    image_io::load_module_for(file);
    const Bytes bytes = isolated(file.string(), {reader_memory_bytes, time_limit}, [&] {
        const Resolution size = size_of(file, convention, ids);
        const auto* first = reinterpret_cast<const std::byte*>(&size);
        return Bytes(first, first + sizeof size);
    });
    Resolution size;
    std::memcpy(&size, bytes.data(), std::min(sizeof size, bytes.size()));
    return size;
}

std::vector<std::string> stored_frame_channels(const fs::path& file,
                                               std::chrono::milliseconds time_limit) try {
    image_io::load_module_for(file);
    const Bytes bytes = isolated(file.string(), {reader_memory_bytes, time_limit}, [&] {
        Bytes all;
        for (const std::string& name : depth_file_channels(file))
            for (const char* c = name.c_str(); c <= name.c_str() + name.size(); ++c)
                all.push_back(std::byte(*c));
        return all;
    });
    std::vector<std::string> names{""};
    for (const std::byte byte : bytes) {
        if (byte == std::byte{0})
            names.emplace_back();
        else
            names.back() += char(byte);
    }
    return names;
} catch (const FrameError&) {
    return {};
}

void refuse_other_size(const std::filesystem::path& file, Resolution size, const View& view) {
    if (size == Resolution{view.width, view.height}) return;
    throw FrameError(file.string() + ": " + size_text(size.width, size.height) + " pixels; the view '" +
                     view.name + "' has " + size_text(view.width, view.height));
}

namespace {

/// The samples as the file has them, the picture, and a copy of it.
constexpr std::size_t picture_bytes_per_pixel = 64;

Bytes bytes_of(const Picture& picture) {
    const auto bytes = std::as_bytes(picture.pixels());
    return {bytes.begin(), bytes.end()};
}

/// 8-bit sRGB as linear light.
Picture picture_of_codes(const std::filesystem::path& file, const View& view) {
    const Rgba8Image image = read_rgba8(file, std::max(view.width, view.height));
    refuse_other_size(file, image.size, view);
    Picture picture{image.size};
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const auto light = [&](std::size_t c) { return float(decoded_srgb(image.rgba[4 * i + c] / 255.0)); };
        picture.pixels()[i] = {light(0), light(1), light(2)};
    }
    return picture;
}

}  // namespace

Picture read_stored_picture(const std::filesystem::path& file, const View& view,
                            std::chrono::milliseconds time_limit) {
    Picture picture({view.width, view.height});
    image_io::load_module_for(file);
    const std::size_t memory = reader_memory_bytes + picture_bytes_per_pixel * picture.size().pixel_count();
    const Bytes bytes = isolated(file.string(), {memory, time_limit}, [&] {
        if (stored_image(file).is_of_bytes) return bytes_of(picture_of_codes(file, view));
        refuse_other_size(file, picture_size(file), view);
        return bytes_of(read_picture(file));
    });
    const auto to = std::as_writable_bytes(picture.pixels());
    if (bytes.size() != to.size()) throw FrameError(file.string() + ": cannot be read: its end is missing");
    std::memcpy(to.data(), bytes.data(), bytes.size());
    return picture;
}

}  // namespace zproof::oracle
