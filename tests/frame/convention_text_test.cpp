#include "frame/convention_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "frame/frame_error.h"
#include "tests/frame/scratch_folder.h"

namespace zproof {
namespace {

std::string refusal(const std::string& convention, const std::string& channels = "") {
    return complaint<FrameError>([&] { convention_from_words(convention, channels); });
}

class ConventionFile : public ScratchFolder {
  protected:
    std::string written(const std::string& text) const {
        std::ofstream(file("mine.json")) << text;
        return file("mine.json").string();
    }
};

TEST(ConventionWord, NothingIsTheContract) { EXPECT_EQ(convention_from_words("", ""), Convention{}); }

TEST(ConventionWord, EveryKeyIsRead) {
    const Convention c = convention_from_words(
        "id_channel=3,depth_channel=a.Z,id_coding=bgr,id_base=4294967295,id_background=-1,background_by="
        "depth,"
        "rows=bottom_first,depth_kind=disparity,depth_scale=0.5,baseline=0.1,depth_background=0|nan|far|1e10",
        "");
    EXPECT_EQ(c.id_channel, "3");
    EXPECT_EQ(c.depth_channel, "a.Z");
    EXPECT_EQ(c.id_coding, IdCoding::bgr);
    EXPECT_EQ(c.id_base, 4294967295u);
    EXPECT_EQ(c.id_background, -1);
    EXPECT_EQ(c.background_by, BackgroundBy::depth);
    EXPECT_EQ(c.rows, RowOrder::bottom_first);
    EXPECT_EQ(c.depth_kind, DepthKind::disparity);
    EXPECT_EQ(c.depth_scale, 0.5);
    EXPECT_EQ(c.baseline, 0.1);
    ASSERT_EQ(c.background_depths.size(), 3u);
    EXPECT_EQ(c.background_depths[0], 0);
    EXPECT_TRUE(std::isnan(c.background_depths[1]));
    EXPECT_EQ(c.background_depths[2], 1e10);
    EXPECT_TRUE(c.far_is_background);
}

TEST(ConventionWord, EveryPresetIsUnderstoodAndMayBeChanged) {
    EXPECT_EQ(convention_names().size(), 6u);
    for (const std::string& name : convention_names())
        EXPECT_NE(convention_from_words(name, ""), Convention{});
    const Convention changed = convention_from_words("bop,depth_scale=0.1", "depth=Y");
    EXPECT_EQ(changed.depth_scale, 0.1);
    EXPECT_EQ(changed.id_background, 0);
    EXPECT_EQ(changed.depth_channel, "Y");
}

TEST(ConventionWord, ChannelsAloneChangeNothingElse) {
    Convention expected;
    expected.id_channel = "primId";
    expected.depth_channel = "Depth";
    EXPECT_EQ(convention_from_words("", "id=primId,depth=Depth"), expected);
}

TEST_F(ConventionFile, SaysTheSameAsAWord) {
    const std::string name =
        written(R"({"preset": "bop", "depth_scale": 0.1, "depth_background": [0, "far"]})");
    EXPECT_EQ(convention_from_words(name, ""),
              convention_from_words("bop,depth_scale=0.1,depth_background=0|far", ""));
}

TEST_F(ConventionFile, MistakesAreNamedWithTheirPlace) {
    EXPECT_NE(refusal(written(R"({"depth_kind": "z"})"))
                  .find("mine.json: /depth_kind: expected camera, ray_length"),
              std::string::npos);
    EXPECT_NE(refusal(written(R"({"preset": "gl"})")).find("/preset: expected one of pytorch3d"),
              std::string::npos);
    EXPECT_NE(
        refusal(written(R"({"id_base": 1, "id_base": 0})")).find("mine.json: byte 15: \"id_base\" stands"),
        std::string::npos);
    EXPECT_NE(refusal(written("[1]")).find("expected a JSON object"), std::string::npos);
    EXPECT_NE(refusal(written("")).find("expected a JSON object"), std::string::npos);
    EXPECT_NE(refusal("none.json").find("none.json: no such file; expected a JSON file"), std::string::npos);
    EXPECT_NE(refusal(written(std::string(70'000, ' '))).find("64 KiB"), std::string::npos);
}

TEST(ConventionWord, MistakesAreNamed) {
    const auto says = [](const std::string& convention, const std::string& expected) {
        EXPECT_NE(refusal(convention).find(expected), std::string::npos) << refusal(convention);
    };
    says("pytorch", "expected one of pytorch3d, nvdiffrast, blender, open3d, mitsuba, bop");
    says("bop,rows", "expected KEY=VALUE, found 'rows'");
    says("scale=2", "/scale: unknown key; did you mean 'depth_scale'?");
    says("planes=2", "/planes: unknown key; allowed here: id_channel, ");
    says("id_base=-1", "/id_base: expected a whole number from 0 to 4294967295, found -1");
    says("id_base=4294967296", "found 4294967296");
    says("id_background=18446744073709551615", "/id_background: expected a whole number or largest");
    says("id_background=1.5", "/id_background: expected a whole number or largest");
    says("depth_scale=0", "/depth_scale: expected a number above 0");
    says("depth_background=0|none", "/depth_background: expected numbers, nan");
    says("depth_scale=\xED", "found \"\xED\"");
    says("depth_kind=disparity", "/baseline: missing");
    says("baseline=1", "/baseline: only a disparity has one");
    says("id_coding=float", "/id_background: missing");
    says("depth_kind=ray_length,depth_background=far", "far: the far plane has no one ray length");
    EXPECT_NE(refusal("", "ids=a").find("expected id=NAME or depth=NAME"), std::string::npos);
    EXPECT_NE(refusal("", "id=").find("/id_channel: expected a channel's name"), std::string::npos);
}

}  // namespace
}  // namespace zproof
