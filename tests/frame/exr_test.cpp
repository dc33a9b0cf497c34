#include "frame/exr.h"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <tbb/task_arena.h>

#include <bit>
#include <fstream>
#include <random>
#include <vector>

#include "frame/exr_encode.h"
#include "frame/frame_error.h"
#include "frame/whole_file.h"
#include "scratch_folder.h"

namespace zproof {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Exr : public ScratchFolder {};

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
struct OtherWriter {
    std::vector<std::string> channels;
    std::vector<OIIO::TypeDesc> types;
    OIIO::ImageSpec spec{4, 3, 2, OIIO::TypeFloat};
};

void write_other_writer(const std::filesystem::path& file, OtherWriter other_writer) {
    other_writer.spec.nchannels = static_cast<int>(other_writer.channels.size());
    other_writer.spec.channelnames = other_writer.channels;
    other_writer.spec.channelformats = other_writer.types;
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(file.string(), other_writer.spec)) << output->geterror();
    const std::vector<std::byte> zeros(other_writer.spec.image_bytes(true));
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, zeros.data())) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

std::string refusal_to_read(const std::filesystem::path& file) {
    return complaint<FrameError>([&] { read_exr(file); });
}

TEST_F(Exr, KeepsEveryBitOfIdsAndDepths) {
    const Frame frame = hard_frame();
    write_exr(file("hard.exr"), frame);
    const Frame back = read_exr(file("hard.exr"));
    EXPECT_EQ(back.size(), frame.size());
    EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
    EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
}

TEST_F(Exr, KeepsRowsAndColumnsInPlaceInALargeFrame) {
    Frame frame({517, 233});
    for (std::size_t i = 0; i < frame.size().pixel_count(); ++i) {
        frame.primitive.pixels()[i] = PrimitiveId{static_cast<std::uint32_t>(0x1000000 + 2654435761u * i)};
        frame.camera_depth.pixels()[i] = static_cast<float>(i) * 0.1f;
    }
    write_exr(file("large.exr"), frame);
    const Frame back = read_exr(file("large.exr"));
    EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
    EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
}

TEST_F(Exr, SameFrameGivesTheSameBytes) {
    write_exr(file("a.exr"), hard_frame());
    write_exr(file("b.exr"), hard_frame());
    const auto bytes = [&](const char* name) {
        std::ifstream in(file(name), std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(in), {}};
    };
    EXPECT_EQ(bytes("a.exr"), bytes("b.exr"));
}

TEST_F(Exr, GivesTheSameBytesForAnyNumberOfThreads) {
    Plane<std::uint32_t> plane({100, 333});
    for (std::size_t i = 0; i < plane.pixels().size(); ++i)
        plane.pixels()[i] = static_cast<std::uint32_t>(i * i / 7);
    const ExrChannel channel{"n", ExrType::uint32, plane.pixels().data()};
    const auto encoded_on = [&](int threads) {
        tbb::task_arena(threads).execute([&] {
            write_exr(file("n.exr"), plane.size(), std::span{&channel, 1});
        });
        return content_of(file("n.exr"));
    };
    EXPECT_EQ(encoded_on(1), encoded_on(2));
    EXPECT_EQ(encoded_on(1), encoded_on(7));
}

TEST_F(Exr, KeepsNoiseThatDoesNotPack) {
    Frame frame({64, 40});
    std::mt19937 random(1);
    for (PrimitiveId& id : frame.primitive.pixels()) id = PrimitiveId{static_cast<std::uint32_t>(random())};
    for (float& depth : frame.camera_depth.pixels())
        depth = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    write_exr(file("noise.exr"), frame);
    const Frame back = read_exr(file("noise.exr"));
    EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
    EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
}

TEST_F(Exr, ReadsAStrangersFileWithMoreChannels) {
    write_other_writer(file("more.exr"),
                       {{"R", "G", "B", "Z", "id"},
                        {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeFloat, OIIO::TypeUInt32}});
    EXPECT_EQ(read_exr(file("more.exr")).primitive.at(3, 2), PrimitiveId{0});
}

/// What another program makes of the ids and depths of a frame.
void write_as_other_writer(const std::filesystem::path& file, const Frame& frame, OIIO::ImageSpec spec) {
    spec.width = spec.full_width = frame.size().width;
    spec.height = spec.full_height = frame.size().height;
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

TEST_F(Exr, ReadsEveryLosslessCompressionOfAStrangerInRowsAndInTiles) {
    const Frame frame = wide_frame();
    for (const char* compression : {"none", "rle", "zips", "zip", "piz"})
        for (const int tile : {0, 32}) {
            SCOPED_TRACE(std::string(compression) + ", tiles of " + std::to_string(tile));
            OIIO::ImageSpec spec(1, 1, 2, OIIO::TypeFloat);
            spec.attribute("compression", compression);
            spec.tile_width = tile, spec.tile_height = tile / 2;
            write_as_other_writer(file("other_writer.exr"), frame, spec);
            const Frame back = read_exr(file("other_writer.exr"));
            EXPECT_EQ(numbers(back.primitive), numbers(frame.primitive));
            EXPECT_EQ(bits(back.camera_depth), bits(frame.camera_depth));
        }
}

TEST_F(Exr, ReadsAPictureWhoseWindowsDoNotBeginAtZero) {
    const Frame frame = wide_frame();
    OIIO::ImageSpec spec(1, 1, 2, OIIO::TypeFloat);
    spec.x = spec.full_x = -7, spec.y = spec.full_y = 100;
    write_as_other_writer(file("moved.exr"), frame, spec);
    EXPECT_EQ(numbers(read_exr(file("moved.exr")).primitive), numbers(frame.primitive));
}

TEST_F(Exr, ReadsPicturesOfAStranger) {
    Picture picture({151, 83});
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        picture.pixels()[i] = {float(i), 1 / float(i + 1), -float(i)};
    OIIO::ImageSpec spec(151, 83, 3, OIIO::TypeFloat);
    spec.tile_width = spec.tile_height = 64;
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(file("picture.exr").string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, picture.pixels().data())) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
    EXPECT_TRUE(std::ranges::equal(read_picture_exr(file("picture.exr")).pixels(), picture.pixels()));
}

TEST_F(Exr, DeepSamplesAreRefused) {
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

TEST_F(Exr, NothingIsPrintedAboutAFileThatIsRefused) {
    std::ofstream(file("lies.exr")) << "this is no OpenEXR file, whatever its name says";
    testing::internal::CaptureStderr();
    refusal_to_read(file("lies.exr"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Exr, MissingFileIsNamed) {
    EXPECT_THAT(refusal_to_read(file("nowhere.exr")),
                AllOf(HasSubstr("nowhere.exr"), HasSubstr("no such file")));
}

TEST_F(Exr, FileThatIsNoExrIsNamed) {
    std::ofstream(file("lies.exr")) << "this is no OpenEXR file, whatever its name says";
    EXPECT_THAT(refusal_to_read(file("lies.exr")), AllOf(HasSubstr("lies.exr"), HasSubstr("OpenEXR")));
}

TEST_F(Exr, TruncatedFileIsRefused) {
    Frame frame({64, 64});
    std::uint32_t noise = 1;
    for (float& depth : frame.camera_depth.pixels())
        depth = static_cast<float>(noise = noise * 1664525u + 1013904223u);
    write_exr(file("cut.exr"), frame);
    std::filesystem::resize_file(file("cut.exr"), std::filesystem::file_size(file("cut.exr")) / 2);
    EXPECT_THAT(
        refusal_to_read(file("cut.exr")),
        AllOf(HasSubstr("cut.exr"), HasSubstr("channel 'id' cannot be read"), HasSubstr("pixel (0, ")));
}

TEST_F(Exr, MissingChannelIsNamedTogetherWithThoseThatAreThere) {
    write_other_writer(file("a.exr"), {{"Z", "object"}, {OIIO::TypeFloat, OIIO::TypeUInt32}});
    EXPECT_THAT(refusal_to_read(file("a.exr")),
                AllOf(HasSubstr("a.exr"), HasSubstr("'id' is missing"), HasSubstr("object")));
    write_other_writer(file("b.exr"), {{"id", "depth"}, {OIIO::TypeUInt32, OIIO::TypeFloat}});
    EXPECT_THAT(refusal_to_read(file("b.exr")), AllOf(HasSubstr("b.exr"), HasSubstr("'Z' is missing")));
}

TEST_F(Exr, ChannelOfAnotherTypeIsRefused) {
    write_other_writer(file("a.exr"), {{"id", "Z"}, {OIIO::TypeFloat, OIIO::TypeFloat}});
    EXPECT_THAT(refusal_to_read(file("a.exr")),
                AllOf(HasSubstr("'id' is of type float"), HasSubstr("expected uint")));
    write_other_writer(file("b.exr"), {{"id", "Z"}, {OIIO::TypeUInt32, OIIO::TypeHalf}});
    EXPECT_THAT(refusal_to_read(file("b.exr")),
                AllOf(HasSubstr("'Z' is of type half"), HasSubstr("expected float")));
}

TEST_F(Exr, DataWindowThatLeavesPixelsOutIsRefused) {
    OtherWriter other_writer{{"id", "Z"}, {OIIO::TypeUInt32, OIIO::TypeFloat}};
    other_writer.spec.full_width = 8;
    write_other_writer(file("part.exr"), other_writer);
    EXPECT_THAT(refusal_to_read(file("part.exr")), HasSubstr("data window"));
}

TEST_F(Exr, FrameWithoutPixelsIsRefusedAndLeavesNoFile) {
    EXPECT_THAT(complaint<FrameError>([&] { write_exr(file("none.exr"), Frame{}); }),
                AllOf(HasSubstr("none.exr"), HasSubstr("0 x 0")));
    EXPECT_EQ(file_count(), 0u);
}

TEST_F(Exr, FolderThatIsNotThereIsNamed) {
    EXPECT_THAT(complaint<FrameError>([&] { write_exr(file("no/such/a.exr"), hard_frame()); }),
                HasSubstr("no/such/a.exr: cannot be written"));
}

}  // namespace
}  // namespace zproof
