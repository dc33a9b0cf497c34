#include "frame/png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <cstring>
#include <fstream>
#include <string>

#include "frame/frame_error.h"
#include "scratch_folder.h"

namespace zproof {
namespace {

class Png : public ScratchFolder {};

Plane<Rgb8> ramp(Resolution size) {
    Plane<Rgb8> picture(size);
    std::uint8_t next = 0;
    for (Rgb8& pixel : picture.pixels()) {
        pixel = {next, static_cast<std::uint8_t>(next + 85), static_cast<std::uint8_t>(255 - next)};
        ++next;
    }
    return picture;
}

TEST_F(Png, KeepsEveryValue) {
    const Plane<Rgb8> picture = ramp({37, 19});
    write_png(file("a.png"), picture);
    const auto input = OIIO::ImageInput::open(file("a.png").string());
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_EQ(input->spec().width, 37);
    EXPECT_EQ(input->spec().height, 19);
    ASSERT_EQ(input->spec().nchannels, 3);
    EXPECT_EQ(input->spec().format, OIIO::TypeUInt8);
    EXPECT_EQ(input->spec().get_string_attribute("oiio:ColorSpace"), "sRGB");
    Plane<Rgb8> back({37, 19});
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, back.pixels().data())) << input->geterror();
    EXPECT_TRUE(std::ranges::equal(back.pixels(), picture.pixels()));
}

TEST_F(Png, FileAndMemoryHoldTheSameBytes) {
    const Plane<Rgb8> picture = ramp({5, 4});
    write_png(file("a.png"), picture);
    std::ifstream in(file("a.png"), std::ios::binary);
    const std::string in_file{std::istreambuf_iterator<char>(in), {}};
    const std::vector<std::byte> in_memory = encode_png(picture);
    ASSERT_EQ(in_file.size(), in_memory.size());
    EXPECT_EQ(std::memcmp(in_file.data(), in_memory.data(), in_file.size()), 0);
    EXPECT_TRUE(in_file.starts_with("\x89PNG\r\n\x1A\n"));
}

TEST_F(Png, PictureWithoutPixelsIsRefused) {
    EXPECT_THAT(complaint<FrameError>([&] { write_png(file("none.png"), {}); }),
                testing::HasSubstr("none.png"));
    EXPECT_THROW(encode_png({}), FrameError);
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(Png, FolderThatIsNotThereIsNamed) {
    EXPECT_THAT(complaint<FrameError>([&] {
                    write_png(file("no/such.png"), ramp({2, 2}));
                }),
                testing::HasSubstr("no/such.png"));
}

}  // namespace
}  // namespace zproof
