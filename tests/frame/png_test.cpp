#include "frame/png_kinds.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <cstring>
#include <fstream>
#include <string>

#include "frame/frame_error.h"
#include "frame/whole_file.h"
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

/// As OpenImageIO reads it.
Plane<Rgb8> read_back(const std::filesystem::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input || input->spec().nchannels != 3 || input->spec().format != OIIO::TypeUInt8) return {};
    EXPECT_EQ(input->spec().get_string_attribute("oiio:ColorSpace"), "sRGB");
    Plane<Rgb8> picture({input->spec().width, input->spec().height});
    EXPECT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, picture.pixels().data())) << input->geterror();
    return picture;
}

TEST_F(Png, KeepsEveryValueHoweverRowsAreWritten) {
    const Plane<Rgb8> picture = ramp({37, 19});
    for (const PngRows rows : {PngRows::as_they_are, PngRows::less_the_upper}) {
        write_png(file("a.png"), picture, rows);
        const Plane<Rgb8> back = read_back(file("a.png"));
        ASSERT_EQ(back.size(), picture.size());
        EXPECT_TRUE(std::ranges::equal(back.pixels(), picture.pixels()));
    }
}

TEST_F(Png, KeepsEveryValueOfWhatIsPackedInPieces) {
    const Plane<Rgb8> picture = ramp({1201, 700});
    for (const PngRows rows : {PngRows::as_they_are, PngRows::less_the_upper}) {
        write_png(file("a.png"), picture, rows);
        EXPECT_TRUE(std::ranges::equal(read_back(file("a.png")).pixels(), picture.pixels()));
    }
}

TEST_F(Png, PaintedWhileItIsWrittenHasTheSameBytes) {
    const Plane<Rgb8> picture = ramp({1201, 700});
    for (const PngRows rows : {PngRows::as_they_are, PngRows::less_the_upper}) {
        write_png(file("before.png"), picture, rows);
        write_png(file("while.png"), picture.size(), rows,
                  [&](int y, std::span<Rgb8> row) { std::ranges::copy(picture.row(y), row.begin()); });
        EXPECT_EQ(content_of(file("while.png")), content_of(file("before.png")));
    }
}

TEST_F(Png, KeepsTheColoursOfIndices) {
    const std::vector<Rgb8> colours{{1, 2, 3}, {250, 251, 252}, {0, 0, 7}};
    Plane<std::uint8_t> indices({5, 3});
    for (std::size_t i = 0; i < 15; ++i) indices.pixels()[i] = static_cast<std::uint8_t>(i * i % 3);
    write_png(file("a.png"), indices, colours);
    const Plane<Rgb8> back = read_back(file("a.png"));
    ASSERT_EQ(back.size(), indices.size());
    for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(back.pixels()[i], colours[indices.pixels()[i]]) << i;
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
    EXPECT_THROW(write_png(file("none.png"), {0, 4}, PngRows::less_the_upper, {}), FrameError);
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
