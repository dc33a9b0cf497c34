#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <string>

#include "frame/frame_error.h"
#include "frame/whole_file.h"
#include "image_io/image_io.h"
#include "tests/frame/scratch_folder.h"

namespace zproof {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ByteImage : public ScratchFolder {};

Plane<Rgb8> ramp(Resolution size) {
    Plane<Rgb8> picture(size);
    std::uint8_t next = 0;
    for (Rgb8& pixel : picture.pixels()) {
        pixel = {next, std::uint8_t(next + 85), std::uint8_t(255 - next)};
        ++next;
    }
    return picture;
}

std::vector<unsigned char> bytes_in_file(const std::filesystem::path& file) {
    const std::string content = content_of(file);
    return {content.begin(), content.end()};
}

/// A PNG in memory as another program writes it.
template <class T>
std::vector<unsigned char> strangers_png(int channels, OIIO::TypeDesc type, const std::vector<T>& samples) {
    OIIO::ImageSpec spec(int(samples.size()) / channels, 1, channels, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create("png");
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    output->set_ioproxy(&memory);
    EXPECT_TRUE(output->open("a.png", spec)) << output->geterror();
    EXPECT_TRUE(output->write_image(type, samples.data())) << output->geterror();
    output->close();
    return bytes;
}

TEST_F(ByteImage, PngKeepsEveryValueAndSaysThatItIsSrgb) {
    const Plane<Rgb8> picture = ramp({1201, 700});
    write_png(file("a.png"), picture);
    const auto input = OIIO::ImageInput::open(file("a.png").string());
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_EQ(input->spec().nchannels, 3);
    EXPECT_EQ(input->spec().format, OIIO::TypeUInt8);
    EXPECT_EQ(input->spec().get_string_attribute("oiio:ColorSpace"), "sRGB");
    Plane<Rgb8> back(picture.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, back.pixels().data())) << input->geterror();
    EXPECT_TRUE(std::ranges::equal(back.pixels(), picture.pixels()));
}

TEST_F(ByteImage, PngInMemoryIsThatOfTheFileAndTheSameEveryTime) {
    const Plane<Rgb8> picture = ramp({37, 19});
    write_png(file("a.png"), picture);
    const std::vector<std::byte> memory = encode_png(picture);
    EXPECT_EQ(content_of(file("a.png")),
              std::string(reinterpret_cast<const char*>(memory.data()), memory.size()));
    EXPECT_EQ(encode_png(picture), memory);
}

TEST_F(ByteImage, PngWithoutPixelsIsRefusedAndLeavesNoFile) {
    EXPECT_THAT(complaint<FrameError>([&] { write_png(file("none.png"), Plane<Rgb8>{}); }),
                AllOf(HasSubstr("none.png"), HasSubstr("0 x 0")));
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(ByteImage, RgbaTexelsComeBackWhereAlphaIsZero) {
    const std::vector<std::uint8_t> rgba{200, 100, 50, 0, 1, 2, 3, 4, 255, 254, 253, 128};
    const std::vector<std::byte> png = encode_png({3, 1}, rgba);
    const Rgba8Image back =
        decode_rgba8({reinterpret_cast<const unsigned char*>(png.data()), png.size()}, 16);
    EXPECT_EQ(back.size, (Resolution{3, 1}));
    EXPECT_EQ(back.rgba, rgba);
    EXPECT_THAT(complaint<FrameError>([&] { encode_png({2, 1}, rgba); }), HasSubstr("12 bytes of texels"));
}

TEST_F(ByteImage, GreyAndMissingAlphaAreFilledIn) {
    using Bytes = std::vector<std::uint8_t>;
    const auto decoded = [](int channels, const Bytes& samples) {
        return decode_rgba8(strangers_png(channels, OIIO::TypeUInt8, samples), 16).rgba;
    };
    EXPECT_THAT(decoded(1, {7, 9}), ElementsAre(7, 7, 7, 255, 9, 9, 9, 255));
    EXPECT_THAT(decoded(2, {7, 0}), ElementsAre(7, 7, 7, 0));
    EXPECT_THAT(decoded(3, {1, 2, 3}), ElementsAre(1, 2, 3, 255));
}

TEST_F(ByteImage, SixteenBitsAreRoundedToEight) {
    const std::vector<std::uint16_t> samples{0, 128, 129, 65535, 65407, 65406};
    EXPECT_THAT(decode_rgba8(strangers_png(3, OIIO::TypeUInt16, samples), 16).rgba,
                ElementsAre(0, 0, 1, 255, 255, 255, 254, 255));
}

TEST_F(ByteImage, TexturesBeyondTheLimitAndBrokenOnesAreRefused) {
    write_png(file("a.png"), ramp({600, 300}));
    std::vector<unsigned char> png = bytes_in_file(file("a.png"));
    EXPECT_THAT(complaint<FrameError>([&] { decode_rgba8(png, 599); }),
                AllOf(HasSubstr("600 x 300"), HasSubstr("at most 599")));
    png.resize(png.size() / 2);
    EXPECT_THAT(complaint<FrameError>([&] { decode_rgba8(png, 600); }), HasSubstr("cannot be read"));
    EXPECT_THAT(complaint<FrameError>([&] { decode_rgba8(std::vector<unsigned char>(64), 600); }),
                HasSubstr("expected a PNG or JPEG"));
}

TEST_F(ByteImage, SixteenBitsOfLinearLightKeepEveryValue) {
    Plane<Rgb16> picture({256, 256});
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        picture.pixels()[i] = {std::uint16_t(i), std::uint16_t(65535 - i), std::uint16_t(i * 40503)};
    const std::vector<std::byte> png = encode_png(picture);
    write_whole_file(file("a.png"), png);
    EXPECT_TRUE(std::ranges::equal(read_rgb16(file("a.png"), {256, 256}).pixels(), picture.pixels()));
    EXPECT_THAT(complaint<FrameError>([&] {
                    read_rgb16(file("a.png"), {256, 255});
                }),
                AllOf(HasSubstr("256 x 256 pixels"), HasSubstr("expected 3 of uint16, 256 x 255")));
    EXPECT_THAT(complaint<FrameError>([&] {
                    read_rgb16(file("gone.png"), {1, 2});
                }),
                HasSubstr("gone.png: no such file"));
    write_png(file("8.png"), ramp({1, 1}));
    EXPECT_THAT(complaint<FrameError>([&] { read_rgb16(file("8.png"), {1, 1}); }), HasSubstr("of uint8"));
}

}  // namespace
}  // namespace zproof
