#include "frame/png.h"

#include <string>

#include "frame/encode.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

static_assert(sizeof(Rgb8) == 3, "pixels are handed over as packed RGB");

std::vector<std::byte> encode_named(const Plane<Rgb8>& picture, const std::string& place) {
    OIIO::ImageSpec spec(picture.size().width, picture.size().height, 3, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 1);  // half the time of the default, a few percent larger
    return encode({"png", spec}, picture.pixels().data(), place);
}

}  // namespace

void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture) {
    write_whole_file(file, encode_named(picture, file.string()));
}

std::vector<std::byte> encode_png(const Plane<Rgb8>& picture) {
    return encode_named(picture, "PNG in memory");
}

}  // namespace zproof
