#include "image_io/raw_frame.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <cmath>

#include "frame/convention_text.h"
#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "tests/frame/scratch_folder.h"
#include "tests/image_io/npy.h"

namespace zproof {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

constexpr std::uint32_t none = 0xFFFF'FFFF;

class RawFrames : public ScratchFolder {
  protected:
    RawFrame read(const std::string& name, const std::string& convention, const std::string& channels = "") {
        return read_raw_frame(path_of(name), convention_from_words(convention, channels));
    }
    std::string refusal(const std::string& name, const std::string& convention,
                        const std::string& channels = "") {
        return complaint<FrameError>([&] { read(name, convention, channels); });
    }
    /// "A+B" are two files of the folder.
    std::filesystem::path path_of(const std::string& name) const {
        const std::size_t plus = name.find('+');
        if (plus == std::string::npos) return file(name);
        return file(name.substr(0, plus)).string() + "+" + file(name.substr(plus + 1)).string();
    }
};

std::vector<std::uint32_t> ids_of(const RawFrame& frame) {
    std::vector<std::uint32_t> ids;
    for (const PrimitiveId id : frame.primitive.value().pixels()) ids.push_back(std::uint32_t(id));
    return ids;
}

std::vector<double> depths_of(const RawFrame& frame) {
    return {frame.stored_depth.pixels().begin(), frame.stored_depth.pixels().end()};
}

/// An image of the types that `spec` says; the file's name says which format.
void write_image(const std::filesystem::path& file, OIIO::ImageSpec spec, std::vector<std::string> names,
                 const void* pixels) {
    spec.channelnames = std::move(names);
    const auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeUnknown, pixels)) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

TEST_F(RawFrames, NamedChannelsOfFloatsAreIdsAndDepths) {
    write_image(file("a.exr"), {2, 2, 2, OIIO::TypeFloat}, {"Layer.Depth.Z", "Layer.id.X"},
                std::vector<float>{7.5f, 0, 2.5f, 1, 1e10f, 16777215, -1, 3}.data());
    const RawFrame frame =
        read("a.exr", "id_coding=float,id_base=1,id_background=0", "id=Layer.id.X,depth=Layer.Depth.Z");
    EXPECT_THAT(ids_of(frame), ElementsAre(none, 0, 16777214, 2));
    EXPECT_THAT(depths_of(frame), ElementsAre(7.5, 2.5, 1e10, -1));
}

TEST_F(RawFrames, RowsFromTheBottomAreTurnedOver) {
    write_npy<std::int32_t>(file("id.npy"), "<i4", "3, 2", {0, 1, 2, 3, 4, 5});
    write_npy<float>(file("z.npy"), "<f4", "3, 2", {0, 1, 2, 3, 4, 5});
    const RawFrame frame = read("id.npy+z.npy", "rows=bottom_first");
    EXPECT_THAT(ids_of(frame), ElementsAre(4, 5, 2, 3, 0, 1));
    EXPECT_THAT(depths_of(frame), ElementsAre(4, 5, 2, 3, 0, 1));
}

TEST_F(RawFrames, AttributesAreTurnedOverAsWell) {
    Frame frame({1, 3});
    frame.attributes.planes[2] = frame.attributes.planes[3] = Plane<float>({1, 3});
    for (int y = 0; y < 3; ++y) frame.attributes.planes[2].at(0, y) = float(y);
    write_frame(file("uv.exr"), frame);
    const Attributes turned = read("uv.exr", "rows=bottom_first").attributes;
    ASSERT_TRUE(turned.has(Attribute::uv));
    EXPECT_FALSE(turned.has(Attribute::normal));
    for (int y = 0; y < 3; ++y) EXPECT_EQ(turned.planes[2].at(0, y), float(2 - y));
}

TEST_F(RawFrames, FloatIdsThatAreNotExactAreRefusedWithTheirPixel) {
    write_npy<double>(file("z.npy"), "<f8", "1, 2", {1, 1});
    const std::string keys = "id_coding=float,id_background=0";
    for (const float bad : {0.5f, 16777216.f, -1.f, NAN}) {
        write_npy<float>(file("id.npy"), "<f4", "1, 2", {3, bad});
        EXPECT_THAT(refusal("id.npy+z.npy", keys),
                    AllOf(HasSubstr("id.npy: channel '0' has "), HasSubstr("in column 1, row 0; expected")))
            << bad;
    }
    write_npy<std::uint16_t>(file("id.npy"), "<f2", "1, 2", {0x67FF, 0x6800});  // 2047, 2048
    EXPECT_THAT(refusal("id.npy+z.npy", keys), AllOf(HasSubstr("2048 in column 1"), HasSubstr("below 2048")));
    write_npy<double>(file("id.npy"), "<f8", "1, 2", {16777217, 4294967294});
    EXPECT_THAT(ids_of(read("id.npy+z.npy", keys)), ElementsAre(16777217, 4294967294));
}

TEST_F(RawFrames, AnIdThatIsNoTrianglesNumberIsRefused) {
    write_npy<float>(file("z.npy"), "<f4", "1, 1", {1});
    const auto refused = [&](std::int64_t id, const std::string& convention) {
        write_npy<std::int64_t>(file("id.npy"), "<i8", "1, 1", {id});
        return refusal("id.npy+z.npy", convention);
    };
    EXPECT_THAT(refused(-1, "id_background=-2"), AllOf(HasSubstr("has -1"), HasSubstr("-2 for background")));
    EXPECT_THAT(refused(0, "id_base=1,id_background=-1"), HasSubstr("a triangle's number from 1 on"));
    EXPECT_THAT(refused(4294967295, "id_background=-1"), HasSubstr("has 4294967295"));
    EXPECT_THAT(refused(INT64_MIN, "id_background=-1"), HasSubstr("has -9223372036854775808"));
    EXPECT_EQ(refused(4294967294, "id_background=-1"), "");
    EXPECT_EQ(refused(4294967295, "id_base=1,id_background=-1"), "");
}

TEST_F(RawFrames, TheLargestOfTheTypeIsBackgroundUnlessDeclared) {
    write_npy<float>(file("z.npy"), "<f4", "1, 2", {1, 1});
    write_npy<std::int32_t>(file("id.npy"), "<i4", "1, 2", {INT32_MAX, 0});
    EXPECT_THAT(ids_of(read("id.npy+z.npy", "depth_scale=2")), ElementsAre(none, 0));
    EXPECT_THAT(ids_of(read("id.npy+z.npy", "id_background=0")), ElementsAre(INT32_MAX, none));
    EXPECT_THAT(ids_of(read("id.npy+z.npy", "background_by=depth")), ElementsAre(INT32_MAX, 0));
}

TEST_F(RawFrames, CodesOfThreeBytesAreIds) {
    const std::vector<std::uint8_t> pixels{1, 2, 3, 255, 0, 0, 0, 0, 0};
    write_image(file("code.png"), {3, 1, 3, OIIO::TypeUInt8}, {"R", "G", "B"}, pixels.data());
    write_npy(file("code.npy"), "|u1", "1, 3, 3", pixels);
    write_npy<float>(file("z.npy"), "<f4", "1, 3", {1, 2, 3});
    for (const std::string name : {"code.png+z.npy", "code.npy+z.npy"}) {
        EXPECT_THAT(ids_of(read(name, "id_coding=rgb,id_background=0")), ElementsAre(0x030201, 255, none));
        EXPECT_THAT(ids_of(read(name, "id_coding=bgr,id_background=0")),
                    ElementsAre(0x010203, 0xFF0000, none));
    }
    EXPECT_THAT(refusal("z.npy", "id_coding=rgb,id_background=0"),
                HasSubstr("'0' is of type float; expected uint8"));
}

TEST_F(RawFrames, SixteenBitPngHoldsDepths) {
    const std::vector<std::uint16_t> millimetres{0, 1000, 65535}, ids{0, 1, 2};
    write_image(file("depth.png"), {3, 1, 1, OIIO::TypeUInt16}, {"Y"}, millimetres.data());
    write_image(file("id.png"), {3, 1, 1, OIIO::TypeUInt16}, {"Y"}, ids.data());
    const RawFrame frame = read("id.png+depth.png", "bop");
    EXPECT_THAT(depths_of(frame), ElementsAre(0, 1000, 65535));
    EXPECT_THAT(ids_of(frame), ElementsAre(none, 0, 1));
    EXPECT_THAT(refusal("id.png", "bop"), HasSubstr("channel 'Z' is missing"));
}

TEST_F(RawFrames, SamplesThatReadingScalesAreRefusedOfIdsAndOfDepths) {
    const std::vector<std::uint16_t> numbers{0, 16, 32};
    OIIO::ImageSpec spec{3, 1, 1, OIIO::TypeUInt16};
    write_image(file("whole.tif"), spec, {"Y"}, numbers.data());
    spec.attribute("oiio:BitsPerSample", 12);
    write_image(file("scaled.tif"), spec, {"Y"}, numbers.data());
    for (const char* name : {"scaled.tif+whole.tif", "whole.tif+scaled.tif"})
        EXPECT_THAT(refusal(name, "bop"), HasSubstr("scaled.tif: 12-bit samples"));
}

TEST_F(RawFrames, ChannelsOfPartsAreNamedWithTheirPart) {
    std::vector<OIIO::ImageSpec> specs(2, OIIO::ImageSpec{2, 1, 2, OIIO::TypeFloat});
    specs[0].channelnames = specs[1].channelnames = {"Z", "I"};
    specs[0].attribute("oiio:subimagename", "left");
    specs[1].attribute("oiio:subimagename", "right");
    const std::vector<float> left{1, 0, 2, 1}, right{3, 2, 4, 3};
    const auto output = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(output->open(file("eyes.exr").string(), 2, specs.data()));
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, left.data()));
    ASSERT_TRUE(output->open(file("eyes.exr").string(), specs[1], OIIO::ImageOutput::AppendSubimage));
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, right.data()));
    ASSERT_TRUE(output->close());
    const std::string keys = "id_coding=float,id_background=-1";
    const RawFrame frame = read("eyes.exr", keys, "id=right:I,depth=right:Z");
    EXPECT_THAT(depths_of(frame), ElementsAre(3, 4));
    EXPECT_THAT(ids_of(frame), ElementsAre(2, 3));
    EXPECT_THAT(refusal("eyes.exr", keys, "id=I,depth=left:Z"),
                AllOf(HasSubstr("'I' stands in several parts"), HasSubstr("left:I"), HasSubstr("right:I")));
}

TEST_F(RawFrames, WithoutDataAPixelIsBackground) {
    OIIO::ImageSpec spec(1, 1, 2, OIIO::TypeFloat);
    spec.x = 1;
    spec.full_width = 3;
    write_image(file("crop.exr"), spec, {"I", "Z"}, std::vector<float>{5, 2}.data());
    const RawFrame frame = read("crop.exr", "id_coding=float,id_background=0", "id=I");
    EXPECT_THAT(ids_of(frame), ElementsAre(none, 5, none));
    EXPECT_THAT(depths_of(frame), ElementsAre(HUGE_VAL, 2, HUGE_VAL));
}

TEST_F(RawFrames, AMissingChannelIsNamedWithWhatThereIs) {
    write_image(file("a.exr"), {1, 1, 2, OIIO::TypeFloat}, {"Z", "prim"}, std::vector<float>{1, 2}.data());
    const RawFrame without_ids = read("a.exr", "depth_scale=2");
    EXPECT_FALSE(without_ids.primitive);
    EXPECT_THAT(without_ids.why_no_ids,
                AllOf(HasSubstr("'id' is missing"), HasSubstr("prim"), HasSubstr("--channels")));
    EXPECT_THAT(refusal("a.exr", "", "id=prim"), HasSubstr("'prim' is of type float; expected an integer"));
    EXPECT_THAT(refusal("a.exr", "", "depth=Depth"), HasSubstr("'Depth' is missing"));
}

TEST_F(RawFrames, ArraysOfABatchOfOneAndOfChannels) {
    std::vector<float> rast;  // nvdiffrast: u, v, z/w, id from 1; rows from the bottom
    for (int i = 0; i < 6; ++i) rast.insert(rast.end(), {0.1f, 0.2f, 0.125f * float(i), float(i)});
    write_npy(file("rast.npy"), "<f4", "1, 3, 2, 4", rast);
    const RawFrame frame = read("rast.npy", "nvdiffrast");
    EXPECT_THAT(ids_of(frame), ElementsAre(3, 4, 1, 2, none, 0));
    EXPECT_THAT(depths_of(frame), ElementsAre(0.5, 0.625, 0.25, 0.375, 0, 0.125));
}

TEST_F(RawFrames, ALargeArrayKeepsItsPixelsInPlace) {
    std::vector<std::int64_t> ids;
    std::vector<double> depths;
    for (int i = 0; i < 700 * 301; ++i) {
        ids.push_back(4'000'000'000 - i);
        depths.push_back(1.0 / (i + 3));
    }
    write_npy(file("id.npy"), "<i8", "700, 301", ids);
    write_npy(file("z.npy"), "<f8", "700, 301, 1", depths);
    const RawFrame frame = read("id.npy+z.npy", "pytorch3d");
    EXPECT_THAT(ids_of(frame), ElementsAreArray(ids));
    EXPECT_THAT(depths_of(frame), ElementsAreArray(depths));
}

}  // namespace
}  // namespace zproof
