// libwebp itself: every run writes WebP, and OpenImageIO's 260 libraries take longer to load than a small
// scene to prove.
#include <webp/encode.h>

#include <memory>
#include <span>

#include "frame/frame_error.h"
#include "frame/number_text.h"
#include "frame/whole_file.h"
#include "image_io/image_io.h"

namespace zproof {
namespace {

constexpr float webp_quality = 70;  // of 100: a sixth of the bytes of a PNG, and lines of a pixel stay whole

struct Freed {
    void operator()(std::uint8_t* bytes) const { WebPFree(bytes); }
};

}  // namespace

void write_webp(const std::filesystem::path& file, const Plane<Rgb8>& picture) {
    static_assert(sizeof(Rgb8) == 3, "pixels are written as packed RGB");
    const Resolution size = picture.size();
    const auto* rgb = reinterpret_cast<const std::uint8_t*>(picture.pixels().data());
    std::uint8_t* encoded = nullptr;
    const std::size_t length =
        WebPEncodeRGB(rgb, size.width, size.height, 3 * size.width, webp_quality, &encoded);
    const std::unique_ptr<std::uint8_t, Freed> bytes(encoded);
    if (length == 0)
        throw FrameError(file.string() + ": " + size_text(size.width, size.height) +
                         " pixels cannot be written as WebP; expected sides of 1 to 16383");
    write_whole_file(file, std::as_bytes(std::span{bytes.get(), length}));
}

}  // namespace zproof
