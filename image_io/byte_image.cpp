// 8-bit and 16-bit images: pictures for people, textures, what POV-Ray writes.
#include <cstring>
#include <string>

#include "frame/frame_error.h"
#include "frame/number_text.h"
#include "frame/whole_file.h"
#include "image_io/image_file.h"
#include "image_io/image_io.h"
#include "image_io/module.h"
#include "image_io/samples.h"

namespace zproof {
namespace {

using namespace image_io;

std::vector<unsigned char> encoded(const Raster& raster, const std::string& place) {
    refuse_bad_size({raster.width, raster.height}, place);
    const ModuleTable& images = module();
    try {
        return images.encode(raster);
    } catch (const std::runtime_error& e) {
        throw FrameError(place + ": cannot be written as an image: " + e.what());
    }
}

std::vector<Channel> rgb_of(Sample sample) { return {{"R", sample}, {"G", sample}, {"B", sample}}; }

Raster raster_of(Resolution size, std::vector<Channel> channels, Light light, const void* pixels,
                 Format format = Format::png) {
    return {.format = format,
            .light = light,
            .width = size.width,
            .height = size.height,
            .channels = std::move(channels),
            .pixels = pixels};
}

std::vector<unsigned char> encoded(const Plane<Rgb8>& picture, Format format, const std::string& place) {
    static_assert(sizeof(Rgb8) == 3, "pixels are written as packed RGB");
    return encoded(
        raster_of(picture.size(), rgb_of(Sample::uint8), Light::srgb, picture.pixels().data(), format),
        place);
}

void write_encoded(const std::filesystem::path& file, const Plane<Rgb8>& picture, Format format) {
    const std::vector<unsigned char> bytes = encoded(picture, format, file.string());
    write_whole_file(file, std::as_bytes(std::span{bytes}));
}

std::vector<std::byte> bytes_of(const std::vector<unsigned char>& png) {
    const auto bytes = std::as_bytes(std::span{png});
    return {bytes.begin(), bytes.end()};
}

std::uint8_t narrowed(std::uint16_t value) { return std::uint8_t((value * 255u + 32767u) / 65535u); }

/// Writes one channel of a row into every fourth byte.
void spread_bytes(const SampleRow& row, std::uint8_t* to) {
    for (int i = 0; i < row.count; ++i) {
        const std::byte* from = row.first + std::size_t(i) * row.stride;
        std::uint16_t wide = 0;
        std::memcpy(&wide, from, row.sample == Sample::uint16 ? 2 : 1);  // little-endian
        to[4 * std::size_t(i)] = row.sample == Sample::uint16 ? narrowed(wide) : std::uint8_t(wide);
    }
}

/// The channel that holds R, G, B or A (0 to 3) in an image of so many channels; -1 if there is none.
int source_of(int component, int channels) {
    const bool is_grey = channels < 3;
    if (component < 3) return is_grey ? 0 : component;
    return channels == 2 || channels == 4 ? channels - 1 : -1;
}

}  // namespace

void write_png(const std::filesystem::path& file, const Plane<Rgb8>& picture) {
    write_encoded(file, picture, Format::png);
}

void write_jpeg(const std::filesystem::path& file, const Plane<Rgb8>& picture) {
    write_encoded(file, picture, Format::jpeg);
}

std::vector<std::byte> encode_png(const Plane<Rgb8>& picture) {
    return bytes_of(encoded(picture, Format::png, "PNG in memory"));
}

std::vector<std::byte> encode_png(Resolution size, std::span<const std::uint8_t> rgba) {
    refuse_bad_size(size, "PNG in memory");
    if (rgba.size() != 4 * size.pixel_count())
        throw FrameError("PNG in memory: " + std::to_string(rgba.size()) + " bytes of texels; expected 4 x " +
                         size_text(size.width, size.height));
    std::vector<Channel> channels = rgb_of(Sample::uint8);
    channels.push_back({"A", Sample::uint8});
    return bytes_of(encoded(raster_of(size, std::move(channels), Light::srgb, rgba.data()), "PNG in memory"));
}

std::vector<std::byte> encode_png(const Plane<Rgb16>& picture) {
    return bytes_of(
        encoded(raster_of(picture.size(), rgb_of(Sample::uint16), Light::linear, picture.pixels().data()),
                "PNG in memory"));
}

namespace {

Rgba8Image rgba8_of(const ImageFile& input, int largest_side) {
    const Resolution size = input.size_of(0);
    const std::vector<Channel>& channels = input.parts()[0].channels;
    if (size.width > largest_side || size.height > largest_side || channels.empty() || channels.size() > 4)
        throw FrameError(input.name() + ": " + size_text(size.width, size.height) + " texels of " +
                         std::to_string(channels.size()) + " channels; expected at most " +
                         std::to_string(largest_side) + " texels on either side and 1 to 4 channels");
    Rgba8Image image{size, std::vector<std::uint8_t>(4 * size.pixel_count(), 255)};
    std::vector<WantedChannel> wanted;
    for (int component = 0; component < 4; ++component)
        if (const int source = source_of(component, int(channels.size())); source >= 0)
            wanted.push_back({{0, source}, [&image, component](const SampleRow& row) {
                                  const std::size_t pixel =
                                      std::size_t(row.y) * std::size_t(image.size.width) + std::size_t(row.x);
                                  spread_bytes(row, image.rgba.data() + 4 * pixel + component);
                              }});
    for (const WantedChannel& one : wanted)
        if (const Sample found = input.channel(one.place).sample;
            found != Sample::uint8 && found != Sample::uint16)
            throw FrameError(input.name() + ": samples of type " + name_of(found) +
                             "; expected 8 or 16 bits");
    input.read(wanted);
    return image;
}

}  // namespace

Rgba8Image decode_rgba8(std::span<const unsigned char> bytes, int largest_side) {
    return rgba8_of(ImageFile(bytes, "image in memory"), largest_side);
}

Rgba8Image read_rgba8(const std::filesystem::path& file, int largest_side, int mip_level) {
    return rgba8_of(ImageFile(file, "an image", mip_level), largest_side);
}

StoredImage stored_image(const std::filesystem::path& file) {
    const ImageFile input(file, "an image");
    const Sample sample = input.channel({0, 0}).sample;
    return {input.parts()[0].mip_levels, is_real(sample), sample == Sample::uint8};
}

Plane<Rgb16> read_rgb16(const std::filesystem::path& file, Resolution size) {
    const ImageFile input(file, "a picture");
    const std::vector<Channel>& channels = input.parts()[0].channels;
    const Resolution found = input.size_of(0);
    const bool fits = found == size && channels.size() == 3 && channels[0].sample == Sample::uint16;
    if (!fits)
        throw FrameError(file.string() + ": " + std::to_string(channels.size()) + " channels of " +
                         name_of(channels[0].sample) + ", " + size_text(found.width, found.height) +
                         " pixels; expected 3 of uint16, " + size_text(size.width, size.height));
    Plane<Rgb16> picture(size);
    std::vector<WantedChannel> wanted;
    for (int c = 0; c < 3; ++c)
        wanted.push_back({{0, c}, [&picture, c](const SampleRow& row) {
                              Rgb16* to = picture.row(row.y).data() + row.x;
                              for (int i = 0; i < row.count; ++i)
                                  std::memcpy(&to[i][std::size_t(c)], row.first + std::size_t(i) * row.stride,
                                              2);
                          }});
    input.read(wanted);
    return picture;
}

}  // namespace zproof
