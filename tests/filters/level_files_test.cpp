// Mip chains that a user brings: as one image per level, or as one file.
#include "filters/commands/level_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "tests/cli/program.h"
#include "tests/frame/scratch_folder.h"

namespace zproof::test {
namespace {

using testing::HasSubstr;
using texture::LinearImage;

constexpr int side = 16;

std::uint8_t grey_of_level(int level) { return std::uint8_t(10 + 40 * level); }

/// By Microsoft's description of the file: a magic word and a header of 124 bytes, of `side` texels with all
/// levels. What follows are the levels one after the other.
std::array<std::uint32_t, 32> dds_header() {
    std::array<std::uint32_t, 32> words{};
    words[0] = 0x20534444;       // "DDS "
    words[1] = 124;              // bytes of the header
    words[2] = 0x00021007;       // caps, height, width, pixel format, mip map count
    words[3] = words[4] = side;  // height, width
    words[7] = std::bit_width(std::uint32_t{side});
    words[19] = 32;          // bytes of the pixel format
    words[27] = 0x00401008;  // texture, mip map, complex
    return words;
}

std::string bytes_of(const std::array<std::uint32_t, 32>& words) {
    return {reinterpret_cast<const char*>(words.data()), sizeof words};
}

/// Uncompressed R8G8B8A8, each level of its own grey.
std::string grey_dds() {
    std::array<std::uint32_t, 32> words = dds_header();
    words[2] |= 8, words[5] = 4 * side;  // pitch
    words[20] = 0x41;                    // RGB with alpha
    words[22] = 32;                      // bits of a pixel
    words[23] = 0x000000FF, words[24] = 0x0000FF00, words[25] = 0x00FF0000, words[26] = 0xFF000000;
    std::string file = bytes_of(words);
    for (int level = 0; side >> level >= 1; ++level) {
        const char grey = char(grey_of_level(level));
        for (int i = 0; i < (side >> level) * (side >> level); ++i) file += {grey, grey, grey, '\xFF'};
    }
    return file;
}

/// BC1: every block of 4 x 4 texels has the ends white and black, and each row the indices 0, 1, 2, 3: white,
/// black, two thirds and one third of white.
std::string block_compressed_dds() {
    std::array<std::uint32_t, 32> words = dds_header();
    words[2] |= 0x80000, words[5] = side * side / 2;  // bytes of level 0
    words[20] = 4, words[21] = 0x31545844;            // "DXT1"
    std::string file = bytes_of(words);
    for (int level = 0; side >> level >= 1; ++level) {
        const int blocks = ((side >> level) + 3) / 4;
        for (int i = 0; i < blocks * blocks; ++i) file += std::string{"\xFF\xFF\0\0\xE4\xE4\xE4\xE4", 8};
    }
    return file;
}

class GivenLevels : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder.path() / name).string(); }
    Folder folder;
};

void expect_same(const std::vector<LinearImage>& found, const std::vector<LinearImage>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].width, expected[i].width);
        EXPECT_EQ(found[i].height, expected[i].height);
        EXPECT_EQ(found[i].texels, expected[i].texels) << "level " << i + 1;
    }
}

TEST_F(GivenLevels, OfOneFileAreThoseOfAFilePerLevel) {
    for (int level = 1; side >> level >= 1; ++level) {
        const std::uint8_t grey = grey_of_level(level);
        write_png(folder.path() / ("l" + std::to_string(level) + ".png"),
                  Plane<Rgb8>(Resolution{side >> level, side >> level}, Rgb8{grey, grey, grey}));
    }
    folder.write("chain.dds", grey_dds());
    const auto in_files = levels_from_files(path("l{level}.png")),
               in_one = levels_from_files(path("chain.dds"));
    ASSERT_TRUE(in_files && in_one);
    EXPECT_EQ(in_files->size(), 4u);
    expect_same(*in_one, *in_files);
}

TEST_F(GivenLevels, OfBlocksAreTheColoursBetweenTheirEnds) {
    folder.write("blocks.dds", block_compressed_dds());
    const auto levels = levels_from_files(path("blocks.dds"));
    ASSERT_TRUE(levels);
    ASSERT_EQ(levels->size(), 4u);
    constexpr std::array<std::uint8_t, 4> codes{255, 0, 170, 85};
    for (const LinearImage& level : *levels)
        for (int row = 0; row < level.height; ++row)
            for (int column = 0; column < level.width; ++column) {
                const std::uint8_t code = codes[std::size_t(column % 4)];
                const std::array<std::uint8_t, 4> texel{code, code, code, 255};
                EXPECT_EQ(level.at(column, row), texture::linear_image({1, 1, texel}).texels.at(0));
            }
}

/// maketx writes TIFF and OpenEXR in tiles, with all levels.
TEST_F(GivenLevels, OfTiffAndOpenExrAreReadToo) {
    write_png(folder.path() / "grey.png", Plane<Rgb8>(Resolution{side, side}, Rgb8{90, 90, 90}));
    write_picture(folder.path() / "grey.exr", Picture(Resolution{side, side}, LinearRgb{0.25f, 2, 0.125f}));
    for (const char* made :
         {"maketx --format tiff -o tiff.tx grey.png", "maketx --format exr -o exr.tx grey.exr"})
        ASSERT_EQ(std::system(("cd " + folder.path().string() + " && " + made + " > /dev/null").c_str()), 0);
    const auto bytes = levels_from_files(path("tiff.tx")), reals = levels_from_files(path("exr.tx"));
    ASSERT_TRUE(bytes && reals);
    ASSERT_EQ(bytes->size(), 4u);
    ASSERT_EQ(reals->size(), 4u);
    const std::array<std::uint8_t, 4> texel{90, 90, 90, 255};
    EXPECT_EQ(bytes->at(3).texels.at(0), texture::linear_image({1, 1, texel}).texels.at(0));
    EXPECT_EQ(reals->at(3).texels.at(0), glm::vec4(0.25f, 2, 0.125f, 1));
}

TEST_F(GivenLevels, AreNoneWhereThereIsNoLevelOne) {
    write_png(folder.path() / "one.png", Plane<Rgb8>(Resolution{4, 4}, Rgb8{1, 2, 3}));
    for (const char* name : {"one.png", "none.png", "l{level}.png"})
        EXPECT_FALSE(levels_from_files(path(name))) << name;
}

TEST_F(GivenLevels, OfABrokenFileAreRefused) {
    folder.write("cut.dds", grey_dds().substr(0, 400));
    EXPECT_THAT(complaint<FrameError>([&] { levels_from_files(path("cut.dds")); }), HasSubstr("cut.dds"));
    folder.write("l1.png", "no image");
    EXPECT_THAT(complaint<FrameError>([&] { levels_from_files(path("l{level}.png")); }), HasSubstr("l1.png"));
}

}  // namespace
}  // namespace zproof::test
