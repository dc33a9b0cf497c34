#include "oracle/convention/stored_picture.h"

#include <cstring>
#include <span>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "image_io/module.h"
#include "oracle/convention/expected_size.h"
#include "oracle/isolated.h"

namespace zproof::oracle {
namespace {

/// Of the samples as the file has them, of the picture, and of a copy of it.
constexpr std::size_t picture_bytes_per_pixel = 64;

Bytes bytes_of(const Picture& picture) {
    const auto bytes = std::as_bytes(picture.pixels());
    return {bytes.begin(), bytes.end()};
}

}  // namespace

Picture read_stored_picture(const std::filesystem::path& file, const View& view,
                            std::chrono::milliseconds time_limit) {
    Picture picture({view.width, view.height});
    image_io::load_module();
    const std::size_t memory = reader_memory_bytes + picture_bytes_per_pixel * picture.size().pixel_count();
    const Bytes bytes = isolated(file.string(), {memory, time_limit}, [&] {
        refuse_other_size(file, picture_size(file), view);
        return bytes_of(read_picture(file));
    });
    const auto to = std::as_writable_bytes(picture.pixels());
    if (bytes.size() != to.size()) throw FrameError(file.string() + ": cannot be read: its end is missing");
    std::memcpy(to.data(), bytes.data(), bytes.size());
    return picture;
}

}  // namespace zproof::oracle
