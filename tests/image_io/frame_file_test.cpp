#include "image_io/image_io.h"

#include <Imath/half.h>
#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <chrono>
#include <cstring>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

#include "frame/frame_error.h"
#include "tests/frame/scratch_folder.h"

namespace zproof {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class FrameFile : public ScratchFolder {};

/// Ids around the limits of float and of uint32, and depths whose bits a conversion would change.
constexpr std::uint32_t hard_ids[] = {0,          1,          0xFFFFFF,   0x1000000,  0x1000001,  0x7FFFFFFF,
                                      0x80000001, 0xFFFFFF7F, 0xFFFFFFFD, 0xFFFFFFFE, 0xFFFFFFFF, 12345678};
constexpr std::uint32_t hard_depth_bits[] = {0x00000000,  // 0
                                             0x80000000,  // -0
                                             0x00000001,  // the smallest denormal
                                             0x807FFFFF,  // the largest negative denormal
                                             0x7F800000,  // inf
                                             0xFF800000,  // -inf
                                             0x7FC00000,  // quiet NaN
                                             0x7FC12345,  // with a payload
                                             0xFFFFFFFF,  // negative, all payload
                                             0x7F800001,  // signalling NaN
                                             0x7F7FFFFF,  // the largest finite
                                             0x3F800001};

Frame hard_frame() {
    Frame frame({4, 3});
    for (std::size_t i = 0; i < 12; ++i) {
        frame.primitive.pixels()[i] = PrimitiveId{hard_ids[i]};
        frame.camera_depth.pixels()[i] = std::bit_cast<float>(hard_depth_bits[i]);
    }
    return frame;
}

std::vector<std::uint32_t> bits(const Plane<float>& plane) {
    std::vector<std::uint32_t> all;
    for (const float value : plane.pixels()) all.push_back(std::bit_cast<std::uint32_t>(value));
    return all;
}

std::vector<std::uint32_t> numbers(const Plane<PrimitiveId>& plane) {
    std::vector<std::uint32_t> all;
    for (const PrimitiveId id : plane.pixels()) all.push_back(static_cast<std::uint32_t>(id));
    return all;
}

/// Channels of a file that another program may have written, all of one type, all values 0.
struct Stranger {
    std::vector<std::string> channels;
    std::vector<OIIO::TypeDesc> types;
    OIIO::ImageSpec spec{4, 3, 2, OIIO::TypeFloat};
};

void write_stranger(const std::filesystem::path& file, Stranger stranger) {
    stranger.spec.nchannels = static_cast<int>(stranger.channels.size());
    stranger.spec.channelnames = stranger.channels;
    stranger.spec.channelformats = stranger.types;
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(file.string(), stranger.spec)) << output->geterror();
    const std::vector<std::byte> zeros(stranger.spec.image_bytes(true));
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, zeros.data())) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

/// Pixels in the types that the file has; its name says which format.
void write_native(const std::filesystem::path& file, const OIIO::ImageSpec& spec, const void* pixels) {
    const auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, pixels)) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

/// One row of sixteen grey samples, each 1 of 15.
constexpr std::string_view png_of_4_bits{
    "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x10\x00\x00\x00\x01"
    "\x04\x00\x00\x00\x00\x37\xe2\x9c\x82\x00\x00\x00\x0b\x49\x44\x41\x54\x78\x9c\x63\x10\x84\x02\x00"
    "\x02\x6d\x00\x89\xa5\xf9\xad\x4f\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82",
    68};

std::string refusal_to_read(const std::filesystem::path& file) {
    return complaint<FrameError>([&] { read_frame(file); });
}

TEST_F(FrameFile, KeepsEveryBitOfIdsAndDepths) {
    const Frame frame = hard_frame();
    write_frame(file("hard.exr"), frame);
    const Frame back = read_frame(file("hard.exr"));
    EXPECT_EQ(back.size(), frame.size());
    EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
    EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
}

TEST_F(FrameFile, KeepsEveryBitOfAttributes) {
    Frame frame = hard_frame();
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        if (attribute_channels[c].attribute == Attribute::normal) continue;
        frame.attributes.planes[c] = Plane<float>({4, 3});
        for (std::size_t i = 0; i < 12; ++i)
            frame.attributes.planes[c].pixels()[i] = std::bit_cast<float>(hard_depth_bits[(i + c) % 12]);
    }
    write_frame(file("attributes.exr"), frame);
    const Frame back = read_frame(file("attributes.exr"));
    EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
    EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        EXPECT_EQ(back.attributes.has(c), frame.attributes.has(c)) << attribute_channels[c].name;
        EXPECT_EQ(bits(back.attributes.planes[c]), bits(frame.attributes.planes[c]));
    }
    write_frame(file("none.exr"), hard_frame());
    EXPECT_FALSE(read_frame(file("none.exr")).attributes.are_given());
}

TEST_F(FrameFile, AnAttributeThatIsNotWholeIsRefused) {
    const OIIO::TypeDesc real = OIIO::TypeFloat, half = OIIO::TypeHalf, id = OIIO::TypeUInt32;
    write_stranger(file("part.exr"),
                   {.channels = {"id", "Z", "normal.X", "normal.Z"}, .types = {id, real, real, real}});
    EXPECT_THAT(refusal_to_read(file("part.exr")),
                AllOf(HasSubstr("'normal.Y'"), HasSubstr("all of them or none")));
    write_stranger(file("half.exr"),
                   {.channels = {"id", "Z", "uv.u", "uv.v"}, .types = {id, real, half, half}});
    EXPECT_THAT(refusal_to_read(file("half.exr")),
                AllOf(HasSubstr("'uv.u'"), HasSubstr("half; expected float")));
}

TEST_F(FrameFile, KeepsRowsAndColumnsInPlaceInALargeFrame) {
    Frame frame({517, 233});
    for (std::size_t i = 0; i < frame.size().pixel_count(); ++i) {
        frame.primitive.pixels()[i] = PrimitiveId{static_cast<std::uint32_t>(0x1000000 + 2654435761u * i)};
        frame.camera_depth.pixels()[i] = static_cast<float>(i) * 0.1f;
    }
    write_frame(file("large.exr"), frame);
    const Frame back = read_frame(file("large.exr"));
    EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
    EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
}

TEST_F(FrameFile, SameFrameGivesTheSameBytesAtAnyTime) {
    write_frame(file("a.exr"), hard_frame());
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // another second, which no file may show
    write_frame(file("b.exr"), hard_frame());
    const auto bytes = [&](const char* name) {
        std::ifstream in(file(name), std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    };
    EXPECT_EQ(bytes("a.exr"), bytes("b.exr"));
}

TEST_F(FrameFile, KeepsNoiseThatDoesNotPack) {
    Frame frame({64, 40});
    std::mt19937 random(1);
    for (PrimitiveId& id : frame.primitive.pixels()) id = PrimitiveId{static_cast<std::uint32_t>(random())};
    for (float& depth : frame.camera_depth.pixels())
        depth = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    write_frame(file("noise.exr"), frame);
    const Frame back = read_frame(file("noise.exr"));
    EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
    EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
}

TEST_F(FrameFile, ReadsAStrangersFileWithMoreChannels) {
    write_stranger(file("more.exr"),
                   {{"R", "G", "B", "Z", "id"},
                    {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeFloat, OIIO::TypeUInt32}});
    EXPECT_EQ(read_frame(file("more.exr")).primitive.at(3, 2), PrimitiveId{0});
}

/// What another program makes of the ids and depths of a frame; a display window of no width is the data
/// window.
void write_as_stranger(const std::filesystem::path& file, const Frame& frame, OIIO::ImageSpec spec) {
    spec.width = frame.size().width, spec.height = frame.size().height;
    if (spec.full_width == 0) spec.full_width = spec.width, spec.full_height = spec.height;
    spec.nchannels = 2;
    spec.channelnames = {"id", "Z"};
    spec.channelformats = {OIIO::TypeUInt32, OIIO::TypeFloat};
    std::vector<std::uint32_t> pixels;
    for (std::size_t i = 0; i < frame.size().pixel_count(); ++i) {
        pixels.push_back(std::uint32_t(frame.primitive.pixels()[i]));
        pixels.push_back(std::bit_cast<std::uint32_t>(frame.camera_depth.pixels()[i]));
    }
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, pixels.data())) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

/// A frame of several blocks and tiles in either direction, the last ones narrower.
Frame wide_frame() {
    Frame frame({151, 83});
    for (std::size_t i = 0; i < frame.size().pixel_count(); ++i) {
        frame.primitive.pixels()[i] = PrimitiveId{hard_ids[i / 5 % 12]};
        frame.camera_depth.pixels()[i] = std::bit_cast<float>(hard_depth_bits[i * i / 7 % 12]);
    }
    return frame;
}

TEST_F(FrameFile, ReadsEveryLosslessCompressionOfAStrangerInRowsAndInTiles) {
    const Frame frame = wide_frame();
    for (const char* compression : {"none", "rle", "zips", "zip", "piz"})
        for (const int tile : {0, 32}) {
            SCOPED_TRACE(std::string(compression) + ", tiles of " + std::to_string(tile));
            OIIO::ImageSpec spec(0, 0, 2, OIIO::TypeFloat);
            spec.attribute("compression", compression);
            spec.tile_width = tile, spec.tile_height = tile / 2;
            write_as_stranger(file("stranger.exr"), frame, spec);
            const Frame back = read_frame(file("stranger.exr"));
            EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
            EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
        }
}

TEST_F(FrameFile, ReadsAPictureWhoseWindowsDoNotBeginAtZero) {
    const Frame frame = wide_frame();
    OIIO::ImageSpec spec(0, 0, 2, OIIO::TypeFloat);
    spec.x = spec.full_x = -7, spec.y = spec.full_y = 100;
    write_as_stranger(file("moved.exr"), frame, spec);
    EXPECT_EQ(numbers(read_frame(file("moved.exr")).primitive), numbers(frame.primitive));
}

/// Rows of the data window that nobody sees are not even in the file.
TEST_F(FrameFile, ReadsOnlyRowsThatTheDisplayWindowShows) {
    Frame frame({3, 2000});
    std::ranges::fill(frame.primitive.pixels(), PrimitiveId{7});
    OIIO::ImageSpec spec(0, 0, 2, OIIO::TypeFloat);
    spec.attribute("compression", "none");
    spec.y = -300, spec.full_width = 3, spec.full_height = 20;
    write_as_stranger(file("tall.exr"), frame, spec);
    std::filesystem::resize_file(file("tall.exr"), std::filesystem::file_size(file("tall.exr")) / 2);
    const std::vector<std::uint32_t> expected(60, 7);
    EXPECT_EQ(numbers(read_frame(file("tall.exr")).primitive), expected);
}

TEST_F(FrameFile, RefusesSamplesThatReadingScales) {
    write_frame(file("z.exr"), Frame({16, 1}));
    const std::vector<std::uint8_t> ids(16, 1);
    OIIO::ImageSpec spec(16, 1, 1, OIIO::TypeUInt8);
    spec.attribute("oiio:BitsPerSample", 4);
    write_native(file("id.tif"), spec, ids.data());
    std::ofstream(file("id.png"), std::ios::binary) << png_of_4_bits;
    for (const char* name : {"id.tif", "id.png"})
        EXPECT_THAT(refusal_to_read(file(name).string() + "+" + file("z.exr").string()),
                    AllOf(HasSubstr(name), HasSubstr("4-bit samples")));
}

TEST_F(FrameFile, ReadsPicturesOfAStranger) {
    Picture picture({151, 83});
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        picture.pixels()[i] = {float(i), 1 / float(i + 1), -float(i)};
    OIIO::ImageSpec spec(151, 83, 3, OIIO::TypeFloat);
    spec.tile_width = spec.tile_height = 64;
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(file("picture.exr").string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, picture.pixels().data())) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
    EXPECT_TRUE(std::ranges::equal(read_picture(file("picture.exr")).pixels(), picture.pixels()));
}

TEST_F(FrameFile, DeepSamplesAreRefused) {
    OIIO::ImageSpec spec(4, 3, 2, OIIO::TypeFloat);
    spec.deep = true;
    spec.channelnames = {"id", "Z"};
    spec.channelformats = {OIIO::TypeUInt32, OIIO::TypeFloat};
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(file("deep.exr").string(), spec)) << output->geterror();
    const OIIO::DeepData samples(spec);
    ASSERT_TRUE(output->write_deep_image(samples)) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
    EXPECT_THAT(refusal_to_read(file("deep.exr")), AllOf(HasSubstr("deep.exr"), HasSubstr("deep samples")));
}

TEST_F(FrameFile, NothingIsPrintedAboutAFileThatIsRefused) {
    std::ofstream(file("lies.exr")) << "this is no OpenEXR file, whatever its name says";
    testing::internal::CaptureStderr();
    refusal_to_read(file("lies.exr"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(FrameFile, MissingFileIsNamed) {
    EXPECT_THAT(refusal_to_read(file("nowhere.exr")),
                AllOf(HasSubstr("nowhere.exr"), HasSubstr("no such file")));
}

TEST_F(FrameFile, FileThatIsNoExrIsNamed) {
    std::ofstream(file("lies.exr")) << "this is no OpenEXR file, whatever its name says";
    EXPECT_THAT(refusal_to_read(file("lies.exr")), AllOf(HasSubstr("lies.exr"), HasSubstr("OpenEXR")));
}

TEST_F(FrameFile, TruncatedFileIsRefused) {
    Frame frame({64, 64});
    std::uint32_t noise = 1;
    for (float& depth : frame.camera_depth.pixels())
        depth = static_cast<float>(noise = noise * 1664525u + 1013904223u);
    write_frame(file("cut.exr"), frame);
    std::filesystem::resize_file(file("cut.exr"), std::filesystem::file_size(file("cut.exr")) / 2);
    EXPECT_THAT(refusal_to_read(file("cut.exr")),
                AllOf(HasSubstr("cut.exr"), HasSubstr("channel 'id' cannot be read"),
                      HasSubstr("in the rows from ")));
}

TEST_F(FrameFile, MissingChannelIsNamedTogetherWithThoseThatAreThere) {
    write_stranger(file("a.exr"), {{"Z", "object"}, {OIIO::TypeFloat, OIIO::TypeUInt32}});
    EXPECT_THAT(refusal_to_read(file("a.exr")),
                AllOf(HasSubstr("a.exr"), HasSubstr("'id' is missing"), HasSubstr("object")));
    write_stranger(file("b.exr"), {{"id", "depth"}, {OIIO::TypeUInt32, OIIO::TypeFloat}});
    EXPECT_THAT(refusal_to_read(file("b.exr")), AllOf(HasSubstr("b.exr"), HasSubstr("'Z' is missing")));
}

TEST_F(FrameFile, ChannelOfAnotherTypeIsRefused) {
    write_stranger(file("a.exr"), {{"id", "Z"}, {OIIO::TypeFloat, OIIO::TypeFloat}});
    EXPECT_THAT(refusal_to_read(file("a.exr")),
                AllOf(HasSubstr("'id' is of type float"), HasSubstr("expected uint")));
    write_stranger(file("h.exr"), {{"id", "Z"}, {OIIO::TypeHalf, OIIO::TypeFloat}});
    EXPECT_THAT(refusal_to_read(file("h.exr")), HasSubstr("'id' is of type half"));
    write_stranger(file("b.exr"), {{"id", "Z"}, {OIIO::TypeUInt32, OIIO::TypeUInt32}});
    EXPECT_THAT(refusal_to_read(file("b.exr")),
                AllOf(HasSubstr("'Z' is of type uint"), HasSubstr("expected float or half")));
}

TEST_F(FrameFile, ReadsDepthsOfTypeHalfExactly) {
    OIIO::ImageSpec spec(256, 256, 2, OIIO::TypeHalf);
    spec.channelnames = {"id", "Z"};
    spec.channelformats = {OIIO::TypeUInt32, OIIO::TypeHalf};
    std::vector<std::byte> pixels(65536 * 6);
    for (std::size_t i = 0; i < 65536; ++i) {
        const auto id = std::uint32_t(0xFFFF'FFFE - i);
        const auto half = std::uint16_t(i);
        std::memcpy(&pixels[6 * i], &id, 4), std::memcpy(&pixels[6 * i + 4], &half, 2);
    }
    write_native(file("half.exr"), spec, pixels.data());
    const Frame frame = read_frame(file("half.exr"));
    for (std::size_t i = 0; i < 65536; ++i) {
        ASSERT_EQ(frame.primitive.pixels()[i], PrimitiveId{std::uint32_t(0xFFFF'FFFE - i)});
        const auto expected = float(Imath::half(Imath::half::FromBits, std::uint16_t(i)));
        ASSERT_EQ(std::bit_cast<std::uint32_t>(frame.camera_depth.pixels()[i]),
                  std::bit_cast<std::uint32_t>(expected))
            << i;
    }
}

TEST_F(FrameFile, WhereTheDataWindowLeavesPixelsOutIsBackground) {
    OIIO::ImageSpec spec(0, 0, 2, OIIO::TypeFloat);
    spec.x = 1, spec.y = 2;
    spec.full_width = 4, spec.full_height = 3;
    Frame inner({2, 1});
    inner.primitive.at(1, 0) = PrimitiveId{7};
    inner.camera_depth.at(1, 0) = 2.5f;
    write_as_stranger(file("part.exr"), inner, spec);
    const Frame frame = read_frame(file("part.exr"));
    ASSERT_EQ(frame.size(), (Resolution{4, 3}));
    EXPECT_EQ(frame_size(file("part.exr")), frame.size());
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) {
            EXPECT_EQ(frame.primitive.at(x, y), x == 2 && y == 2 ? PrimitiveId{7} : PrimitiveId::none);
            EXPECT_EQ(frame.camera_depth.at(x, y), x == 2 && y == 2 ? 2.5f : background_depth);
        }
}

TEST_F(FrameFile, WhatLiesBeyondTheDisplayWindowIsPassedOver) {
    const Frame frame = wide_frame();
    OIIO::ImageSpec spec(0, 0, 2, OIIO::TypeFloat);
    spec.x = -3, spec.y = -2;
    spec.full_width = 140, spec.full_height = 70;
    write_as_stranger(file("over.exr"), frame, spec);
    const Frame back = read_frame(file("over.exr"));
    ASSERT_EQ(back.size(), (Resolution{140, 70}));
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 140; ++x) ASSERT_EQ(back.primitive.at(x, y), frame.primitive.at(x + 3, y + 2));
}

/// The ids and the depths of a frame as two images of one channel in one file, the depths first.
void write_two_images(const std::filesystem::path& file, const char* format, const Frame& frame,
                      std::array<const char*, 2> channels) {
    const auto [width, height] = frame.size();
    std::vector<OIIO::ImageSpec> specs{{width, height, 1, OIIO::TypeFloat},
                                       {width, height, 1, OIIO::TypeUInt32}};
    for (std::size_t i = 0; i < 2; ++i) {
        specs[i].channelnames = {channels[i]};
        specs[i].attribute("oiio:subimagename", i == 0 ? "depths" : "ids");
    }
    const auto output = OIIO::ImageOutput::create(format);
    ASSERT_TRUE(output->open(file.string(), 2, specs.data())) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, frame.camera_depth.pixels().data()))
        << output->geterror();
    ASSERT_TRUE(output->open(file.string(), specs[1], OIIO::ImageOutput::AppendSubimage))
        << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, frame.primitive.pixels().data()))
        << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

void expect_same(const Frame& found, const Frame& expected) {
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(numbers(found.primitive), numbers(expected.primitive));
    EXPECT_EQ(bits(found.camera_depth), bits(expected.camera_depth));
}

TEST_F(FrameFile, ReadsChannelsOfSeveralParts) {
    write_two_images(file("parts.exr"), "openexr", wide_frame(), {"Z", "id"});
    expect_same(read_frame(file("parts.exr")), wide_frame());
}

TEST_F(FrameFile, RefusesAChannelOfTwoParts) {
    write_two_images(file("parts.exr"), "openexr", wide_frame(), {"id", "id"});
    EXPECT_THAT(refusal_to_read(file("parts.exr")), HasSubstr("channel 'id' stands in several parts"));
}

TEST_F(FrameFile, RefusesATiffWhoseRowsBeginBelow) {
    OIIO::ImageSpec spec{4, 2, 1, OIIO::TypeUInt32};
    spec.attribute("Orientation", 4);
    const auto output = OIIO::ImageOutput::create("tiff");
    ASSERT_TRUE(output->open(file("turned.tif").string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, std::vector<std::uint32_t>(8).data()));
    ASSERT_TRUE(output->close());
    EXPECT_THAT(refusal_to_read(file("turned.tif")), HasSubstr("its orientation is 4; expected 1"));
}

TEST_F(FrameFile, ReadsPagesOfTiff) {
    write_two_images(file("pages.tif"), "tiff", wide_frame(), {"Y", "Y"});
    expect_same(read_frame(file("pages.tif")), wide_frame());
}

TEST_F(FrameFile, ReadsAPngOf16BitIdsBesideAPfmOfDepths) {
    Frame frame({5, 3});
    std::vector<std::uint16_t> ids;
    for (std::size_t i = 0; i < 15; ++i) {
        ids.push_back(i == 4 ? 0xFFFF : std::uint16_t(65534 - i));
        frame.primitive.pixels()[i] = i == 4 ? PrimitiveId::none : PrimitiveId{std::uint32_t(65534 - i)};
        frame.camera_depth.pixels()[i] = i == 4 ? background_depth : 0.1f * float(i);
    }
    write_native(file("id.png"), {5, 3, 1, OIIO::TypeUInt16}, ids.data());
    // PFM: rows from the bottom up; a negative scale says little-endian.
    std::ofstream pfm(file("z.pfm"), std::ios::binary);
    pfm << "Pf\n5 3\n-1.0\n";
    for (const int y : {2, 1, 0})
        pfm.write(reinterpret_cast<const char*>(frame.camera_depth.row(y).data()), 5 * sizeof(float));
    pfm.close();
    expect_same(read_frame(file("id.png").string() + "+" + file("z.pfm").string()), frame);
    EXPECT_THAT(refusal_to_read(file("id.png")), AllOf(HasSubstr("'Z' is missing"), HasSubstr("IDS+DEPTHS")));
    EXPECT_THAT(refusal_to_read(file("z.pfm")), HasSubstr("'id' is missing"));
}

TEST_F(FrameFile, IdsAndDepthsOfUnlikeSizesAreRefused) {
    const std::vector<std::uint16_t> ids(15);
    write_native(file("id.png"), {5, 3, 1, OIIO::TypeUInt16}, ids.data());
    write_frame(file("z.exr"), Frame({4, 3}));
    EXPECT_THAT(refusal_to_read(file("id.png").string() + "+" + file("z.exr").string()),
                AllOf(HasSubstr("depths of 4 x 3 pixels"), HasSubstr("5 x 3")));
}

TEST_F(FrameFile, PicturesOfBytesAreNoLinearLight) {
    write_png(file("a.png"), Plane<Rgb8>({2, 2}));
    EXPECT_THAT(complaint<FrameError>([&] { read_picture(file("a.png")); }),
                AllOf(HasSubstr("'R' is of type uint8"), HasSubstr("expected float or half")));
}

TEST_F(FrameFile, FrameWithoutPixelsIsRefusedAndLeavesNoFile) {
    EXPECT_THAT(complaint<FrameError>([&] { write_frame(file("none.exr"), Frame{}); }),
                AllOf(HasSubstr("none.exr"), HasSubstr("0 x 0")));
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(FrameFile, FolderThatIsNotThereIsNamed) {
    EXPECT_THAT(complaint<FrameError>([&] { write_frame(file("no/such/a.exr"), hard_frame()); }),
                HasSubstr("no/such/a.exr: cannot be written"));
}

}  // namespace
}  // namespace zproof
