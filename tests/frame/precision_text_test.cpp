#include "frame/precision_text.h"

#include <gtest/gtest.h>

#include <fstream>

#include "frame/frame_error.h"
#include "tests/frame/scratch_folder.h"

namespace zproof {
namespace {

std::string refusal(const std::string& word) {
    try {
        precision_from_word(word);
    } catch (const FrameError& e) {
        return e.what();
    }
    return "nothing was refused";
}

TEST(PrecisionText, ComesBackKeyForKey) {
    const RasterPrecision unusual{.transform = Arithmetic::float64,
                                  .origin = Origin::eye,
                                  .subpixel_bits = 4,
                                  .snap = Snap::truncate,
                                  .clipping = Clipping::view_volume,
                                  .depth_buffer = DepthBuffer::reversed_z,
                                  .depth_interpolation = DepthInterpolation::plane,
                                  .interpolation = Arithmetic::float64,
                                  .depth_roundings = 1};
    for (const Precision& precision :
         {Precision{unusual}, Precision{RasterPrecision{}}, Precision{RayPrecision{Arithmetic::float64}},
          Precision{RayPrecision{}},
          Precision{PlaneRayPrecision{.aim_offset_px = 0x1p-28, .depth_of_range = 0x1p-29}}}) {
        const std::string text = precision_to_json(precision);
        EXPECT_EQ(precision_to_json(precision_from_json(text, "here")), text);
    }
    const auto back = std::get<RasterPrecision>(precision_from_json(precision_to_json(unusual), "here"));
    EXPECT_EQ(back.transform, unusual.transform);
    EXPECT_EQ(back.subpixel_bits, unusual.subpixel_bits);
    EXPECT_EQ(back.snap, unusual.snap);
    EXPECT_EQ(back.origin, unusual.origin);
    EXPECT_EQ(back.clipping, unusual.clipping);
    EXPECT_EQ(back.depth_buffer, unusual.depth_buffer);
    EXPECT_EQ(back.interpolation, unusual.interpolation);
    EXPECT_EQ(back.depth_roundings, unusual.depth_roundings);
}

class PrecisionFile : public ScratchFolder {};

TEST_F(PrecisionFile, SaysTheSameAsOneWord) {
    const std::string word = file("mine.json").string();
    std::ofstream{word} << R"({"kind": "raster", "subpixel_bits": 4, "snap": "truncate"})";
    EXPECT_EQ(precision_to_json(precision_from_word("raster,subpixel_bits=4,snap=truncate")),
              precision_to_json(precision_from_word(word)));
    EXPECT_EQ(precision_to_json(precision_from_word("ray,arithmetic=float64")),
              precision_to_json(RayPrecision{Arithmetic::float64}));
}

TEST(PrecisionText, ARefusalNamesPlaceAndRemedy) {
    EXPECT_EQ(refusal("raster,subpixel_bits=99"),
              "precision 'raster,subpixel_bits=99': /subpixel_bits: expected a whole number from 0 to 16, "
              "found 99");
    EXPECT_NE(refusal("raster,subpixel_bits=4.5").find("whole number"), std::string::npos);
    EXPECT_NE(
        refusal("raster,planes=8").find("/planes: unknown key; allowed here: kind, projections, transform"),
        std::string::npos);
    EXPECT_NE(refusal("raster,snap=round")
                  .find("expected \"nearest\" or \"truncate\" or \"none\", found \"round\""),
              std::string::npos);
    EXPECT_NE(refusal("raster,snap=\xCF").find("found \"\xCF\""), std::string::npos);
    EXPECT_NE(refusal("ray,subpixel_bits=4").find("unknown key"), std::string::npos);
    EXPECT_NE(refusal("plane_ray,aim_offset_px=-1").find("from 0 to 1, found -1"), std::string::npos);
    EXPECT_NE(complaint<FrameError>([] {
                  precision_from_json(R"({"kind": "raster", "kind": "ray"})", "mine.json");
              }).find("mine.json: byte 19: \"kind\" stands twice in its object"),
              std::string::npos);
    EXPECT_NE(refusal("raster,nonsense").find("KEY=VALUE"), std::string::npos);
    EXPECT_NE(refusal("/no/such/file.json").find("no such file; expected a JSON file, a preset"),
              std::string::npos);
    EXPECT_NE(refusal("ray,arithmetic=\xB6").find("found \"\xB6\""), std::string::npos);
    EXPECT_THROW(precision_from_json("[1]", "x"), FrameError);
    EXPECT_THROW(precision_from_json("{", "x"), FrameError);
    EXPECT_THROW(precision_from_json("{}", "x"), FrameError);
    EXPECT_THROW(precision_from_json(R"({"kind": "raster", "snap": null})", "x"), FrameError);
    EXPECT_THROW(precision_from_json(std::string(1 << 17, ' '), "x"), FrameError);
}

}  // namespace
}  // namespace zproof
