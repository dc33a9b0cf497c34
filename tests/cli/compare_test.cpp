// zproof compare, and everything else that is told of renderers, on the real program.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

using nlohmann::json;

class StoredFrames : public testing::Test {
  protected:
    StoredFrames() {
        folder.write("two.gltf", two_triangles());
        const Words small{"--width", "64", "--height", "48"};
        for (const std::string renderer : {"zproof", "embree"}) {
            Words words{"render", "two.gltf", "-o", renderer, "--renderer", renderer};
            words.insert(words.end(), small.begin(), small.end());
            EXPECT_EQ(run(folder, words).exit_code, 0);
        }
    }

    /// zproof's frame with one id that is wrong.
    void spoil(const std::string& name) const {
        Frame frame = read_frame(folder.path() / "zproof/frame-all.exr");
        frame.primitive.at(32, 24) = PrimitiveId{1 - std::uint32_t(frame.primitive.at(32, 24))};
        write_frame(folder.path() / name, frame);
    }

    json only_view() const { return json::parse(folder.read("zproof-out/results.json")).at("views").at(0); }

    Folder folder;
};

TEST_F(StoredFrames, AreJudgedAgainstEmbreeAndAgainstEachOther) {
    const Ran alone = run(folder, {"compare", "zproof/frame-all.exr", "two.gltf"});
    EXPECT_EQ(alone.exit_code, 0) << alone.out << alone.err;
    EXPECT_EQ(only_view().at("candidate"), "zproof/frame-all.exr");
    EXPECT_EQ(only_view().at("reference"), "embree");
    EXPECT_EQ(only_view().at("width"), 64);
    const Ran both = run(folder, {"compare", "zproof/frame-all.exr", "embree/frame-all.exr", "--scene",
                                  "two.gltf", "--reference-precision", "ray"});
    EXPECT_EQ(both.exit_code, 0) << both.out << both.err;
    EXPECT_EQ(only_view().at("reference"), "embree/frame-all.exr");
}

TEST_F(StoredFrames, AWrongPixelFailsAndItsCommandExplainsIt) {
    spoil("spoilt frame.exr");
    const Ran ran = run(folder, {"compare", "spoilt frame.exr", "two.gltf"});
    EXPECT_EQ(ran.exit_code, 1) << ran.out << ran.err;
    EXPECT_EQ(only_view().at("defects"), 1);
    const std::string command = only_view().at("worst").at(0).at("command");
    EXPECT_EQ(command.find("zproof explain two.gltf 32 24"), 0u) << command;
    EXPECT_NE(command.find("--candidate 'spoilt frame.exr'"), std::string::npos) << command;
    const Ran told = run(folder, {"explain", "two.gltf", "32", "24", "--candidate", "spoilt frame.exr",
                                  "--width", "64", "--height", "48"});
    EXPECT_EQ(told.exit_code, 1) << told.out << told.err;
}

TEST_F(StoredFrames, AreJudgedByTheirAttributesToo) {
    const Words render{"render", "two.gltf", "-o", "with", "--attributes", "--width", "64", "--height", "48"};
    ASSERT_EQ(run(folder, render).exit_code, 0);
    const Ran right = run(folder, {"compare", "with/frame-all.exr", "two.gltf"});
    EXPECT_EQ(right.exit_code, 0) << right.out << right.err;
    EXPECT_EQ(right.out.find("not judged"), std::string::npos) << right.out;
    EXPECT_NE(right.out.find("\nnote: two: attributes judged: bary, position\n"), std::string::npos)
        << right.out;
    EXPECT_EQ(only_view().at("notes").back(), "attributes judged: bary, position");
    EXPECT_EQ(only_view().at("attributes"), json({"bary", "position"}));

    Frame frame = read_frame(folder.path() / "with/frame-all.exr");
    ASSERT_TRUE(frame.attributes.has(Attribute::barycentrics));
    frame.attributes.planes[0] = Plane<float>(frame.size());
    write_frame(folder.path() / "unnamed.exr", frame);
    const Ran by_depth = run(folder, {"compare", "unnamed.exr", "two.gltf", "--ids", "none"});
    EXPECT_EQ(by_depth.exit_code, 0) << by_depth.out << by_depth.err;
    EXPECT_NE(by_depth.out.find("the frame names no triangles"), std::string::npos) << by_depth.out;

    frame = read_frame(folder.path() / "with/frame-all.exr");
    ASSERT_FALSE(frame.attributes.has(Attribute::uv));
    frame.attributes.planes[0].at(32, 24) += 0.01f;
    frame.attributes.planes[2] = frame.attributes.planes[3] = Plane<float>(frame.size());
    write_frame(folder.path() / "spoilt.exr", frame);
    const Ran wrong = run(folder, {"compare", "spoilt.exr", "two.gltf"});
    EXPECT_EQ(wrong.exit_code, 1) << wrong.out << wrong.err;
    const std::string remark = "uv not judged: the scene has none";
    EXPECT_NE(wrong.out.find(remark), std::string::npos) << wrong.out;
    EXPECT_EQ(wrong.out.find(remark), wrong.out.rfind(remark)) << wrong.out;
    EXPECT_EQ(only_view().at("notes").back(), remark);
    EXPECT_EQ(only_view().at("counts").at("wrong_attribute"), 1);
    const json finding = only_view().at("worst").at(0);
    EXPECT_EQ(finding.at("class"), "wrong_attribute");
    EXPECT_EQ(finding.at("wrong_attribute").at("channel"), "bary.u");
    const Ran told = run(folder, {"explain", "two.gltf", "32", "24", "--candidate", "spoilt.exr", "--width",
                                  "64", "--height", "48"});
    EXPECT_EQ(told.exit_code, 1) << told.out << told.err;
    EXPECT_NE(told.out.find("an attribute is not: bary.u is "), std::string::npos) << told.out;
}

/// The planes of triangles that reach across the guard band promise nothing of what lies between corners.
TEST_F(StoredFrames, SayAtHowManyPixelsDepthsAndAttributesAreOpen) {
    const Words render{"render",  "guard_band", "-o",       "far", "--attributes",
                       "--width", "64",         "--height", "48"};
    ASSERT_EQ(run(folder, render).exit_code, 0);
    const auto notes_by = [&](const std::string& precision) {
        const Ran ran = run(
            folder, {"compare", "far/ahead.exr", "guard_band", "--view", "ahead", "--precision", precision});
        EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
        return only_view().at("notes");
    };
    const std::string judged = "attributes judged: bary, position";
    const auto open = [](const std::string& what, const std::string& pixels) {
        return what + " not judged at some pixels: " + pixels +
               " of 3,072, where rounding may leave a triangle no area";
    };
    EXPECT_EQ(notes_by("raster"), json({judged}));
    EXPECT_EQ(notes_by("d3d11"), json({open("depths", "2,848"), open("attributes", "2,847"), judged}));
}

/// A channel that looks like an attribute and is none is named, whoever wrote the file; a layer's are judged.
TEST_F(StoredFrames, SayWhichChannelsAreNearlyAttributes) {
    const Frame frame = read_frame(folder.path() / "zproof/frame-all.exr");
    const Plane<float> garbage(frame.size(), 7);
    Plane<std::uint32_t> ids(frame.size());
    std::ranges::transform(frame.primitive.pixels(), ids.pixels().begin(),
                           [](PrimitiveId id) { return std::uint32_t(id); });
    const auto write = [&](const std::string& file, const std::vector<std::string>& names) {
        std::vector<NamedPlane> planes{{"id", &ids}, {"Z", &frame.camera_depth}};
        for (const std::string& name : names) planes.push_back({name, &garbage});
        write_planes(folder.path() / file, planes, {});
    };
    write("misnamed.exr", {"uv.x", "Uv.v", "L.normal.x", "bary_u", "R", "spectrum.u"});
    const std::vector<std::string> remarks{"channels not judged: 'bary_u'; did you mean 'bary.u'?",
                                           "channels not judged: 'L.normal.x'; did you mean 'normal.X'?",
                                           "channels not judged: 'Uv.v'; did you mean 'uv.v'?",
                                           "channels not judged: 'uv.x'; did you mean 'uv.u'?"};
    const Ran compared = run(folder, {"compare", "misnamed.exr", "two.gltf"});
    EXPECT_EQ(compared.exit_code, 0) << compared.out << compared.err;
    for (const std::string& remark : remarks)
        EXPECT_NE(compared.out.find(remark), std::string::npos) << compared.out;
    EXPECT_NE(folder.read("zproof-out/report.html").find("did you mean"), std::string::npos);
    EXPECT_EQ(only_view().at("notes"), json(remarks));
    const Ran program = run(folder, {"run", "two.gltf", "--renderer", "cp misnamed.exr {out}", "--width",
                                     "64", "--height", "48"});
    EXPECT_EQ(program.exit_code, 0) << program.out << program.err;
    EXPECT_EQ(only_view().at("notes"), json(remarks));

    write("layer.exr", {"L.bary.u", "L.bary.v"});
    const Ran layer = run(folder, {"compare", "layer.exr", "two.gltf"});
    EXPECT_EQ(layer.exit_code, 1) << layer.out << layer.err;
    EXPECT_EQ(only_view().at("notes"), json({"attributes judged: bary"}));
}

TEST_F(StoredFrames, AWrongPixelOfTheReferenceDoesNotFail) {
    spoil("spoilt.exr");
    const Ran ran = run(folder, {"compare", "zproof/frame-all.exr", "spoilt.exr", "--scene", "two.gltf"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(only_view().at("reference_defects"), 1);
}

TEST_F(StoredFrames, AReferenceOfAnotherSizeLeavesAReportThatSaysSo) {
    write_frame(folder.path() / "small.exr", Frame({8, 8}));
    const Ran ran = run(folder, {"compare", "zproof/frame-all.exr", "small.exr", "--scene", "two.gltf"});
    EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
    EXPECT_EQ(only_view().at("outcome"), "unreadable");
    EXPECT_EQ(only_view().at("message"), "small.exr: 8 x 8 pixels; the view 'frame-all' has 64 x 48");
}

TEST_F(StoredFrames, OfTheWrongKindAreRefusedAndNothingIsWritten) {
    folder.write("words.exr", "no frame");
    for (const Words& words :
         {Words{"compare", "words.exr", "two.gltf"}, Words{"compare", "absent.exr", "two.gltf"},
          Words{"compare", "zproof/frame-all.exr", "absent.gltf"}}) {
        const Ran ran = run(folder, words);
        EXPECT_EQ(ran.exit_code, 3) << ran.out << ran.err;
        EXPECT_EQ(std::ranges::count(folder.names(), "zproof-out"), 0);
    }
    EXPECT_EQ(run(folder, {"compare", "zproof/frame-all.exr", "two.gltf", "--view", "none"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"compare", "zproof/frame-all.exr", "off_axis"}).exit_code, 2);
    EXPECT_EQ(
        run(folder, {"compare", "zproof/frame-all.exr", "two.gltf", "--precision", "raster,subpixel_bits=99"})
            .exit_code,
        2);
    EXPECT_EQ(run(folder, {"compare", "zproof/frame-all.exr"}).exit_code, 2);
}

TEST_F(StoredFrames, DeclaredPrecisionDecides) {
    const Words one_bit{"run",      "off_axis", "--renderer",  "zproof",
                        "--oracle", "none",     "--width",     "160",
                        "--height", "100",      "--precision", "raster,subpixel_bits=14"};
    EXPECT_EQ(run(folder, one_bit).exit_code, 1);  // it snaps to 8 bits
    EXPECT_EQ(
        only_view().at("counts").at("outside").get<int>() + only_view().at("counts").at("hole").get<int>() >
            0,
        true);
}

TEST_F(StoredFrames, AnOracleThatIsNotInstalledIsNamedAndMayBeRequired) {
    const Words run_words{"run", "two.gltf", "--width", "64", "--height", "48"};
    const Words nowhere{"PATH=/no/such/folder"};
    const Ran without = run(folder, run_words, nowhere);
    EXPECT_EQ(without.exit_code, 0) << without.out << without.err;
    EXPECT_NE(without.out.find("povray: not compared in 1 view: not installed"), std::string::npos)
        << without.out;
    EXPECT_NE(folder.read("zproof-out/report.html").find("not installed"), std::string::npos);
    Words required = run_words;
    required.insert(required.end(), {"--require", "povray"});
    const Ran refused = run(folder, required, nowhere);
    EXPECT_EQ(refused.exit_code, 3) << refused.out << refused.err;
    EXPECT_NE(refused.err.find("povray: not installed"), std::string::npos) << refused.err;
    EXPECT_EQ(run(folder, required).exit_code, 0);
}

TEST_F(StoredFrames, PovRayIsNotAskedUnnamedWhereItTakesLongerThanTheRest) {
    const Ran ran = run(folder, {"run", "two.gltf", "--width", "960", "--height", "540"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("povray: not compared in 1 view: not asked, since it takes longer than all the "
                           "rest; --oracle povray:sample asks it\n"),
              std::string::npos)
        << ran.out;
    const json renderers = json::parse(folder.read("zproof-out/results.json")).at("run").at("renderers");
    ASSERT_EQ(renderers.size(), 3u) << "candidate, reference and POV-Ray";
    EXPECT_EQ(renderers.at(2).at("version").get<std::string>().substr(0, 8), "POV-Ray ");
}

TEST_F(StoredFrames, PovRayIsAskedAboutASampleOrAboutEveryPixel) {
    const Words run_words{"run", "two.gltf", "--width", "960", "--height", "540", "--evidence", "all"};
    Words sample = run_words;
    sample.insert(sample.end(), {"--oracle", "povray:sample"});
    const Ran ran = run(folder, sample);
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const json view = only_view(), oracle = view.at("oracles").at(0);
    EXPECT_EQ(oracle.at("absent"), "");
    EXPECT_EQ(oracle.at("sample").at("pixels"), 320 * 180);
    EXPECT_EQ(oracle.at("sample").at("stride"), 3);
    EXPECT_EQ(view.at("id_agreement").at("same").at(0).at(0), 320 * 180);
    EXPECT_EQ(view.at("id_agreement").at("same").at(2).at(2), 320 * 180);
    EXPECT_GT(view.at("id_agreement").at("same").at(0).at(2), 320 * 180 - 100);
    const std::string words = "57,600 of 518,400 pixels, chosen by seed 1";
    EXPECT_NE(ran.out.find(words), std::string::npos) << ran.out;
    EXPECT_NE(folder.read("zproof-out/report.html").find(words), std::string::npos);

    Words named = run_words;
    named.insert(named.end(), {"--oracle", "povray"});
    EXPECT_EQ(run(folder, named).exit_code, 0);
    EXPECT_FALSE(only_view().at("oracles").at(0).contains("sample"));
    EXPECT_EQ(only_view().at("id_agreement").at("same").at(2).at(2), 960 * 540);
}

/// A POV-Ray that is not shown the last triangle of its scene file.
TEST_F(StoredFrames, DefectsOfASampleAreToldInPixelsOfTheImage) {
    folder.write(
        "bin/povray",
        "#!/bin/sh\n"
        "[ -f scene.pov ] && sed -i \"$(grep -n '^triangle' scene.pov | tail -1 | cut -d: -f1)d\" scene.pov\n"
        "exec /usr/bin/povray \"$@\"\n");
    std::filesystem::permissions(folder.path() / "bin/povray", std::filesystem::perms::owner_all);
    const Ran ran = run(folder, {"run", "two.gltf", "--width", "960x540", "--oracle", "povray:sample"},
                        {"PATH=" + (folder.path() / "bin").string() + ":/usr/bin:/bin"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;  // a reference's defects are its own
    const json oracle = only_view().at("oracles").at(0), first = oracle.at("sample").at("first");
    ASSERT_GT(oracle.at("defects"), 100);
    const Frame ours = [&] {
        EXPECT_EQ(
            run(folder, {"render", "two.gltf", "-o", "whole", "--width", "960", "--height", "540"}).exit_code,
            0);
        return read_frame(folder.path() / "whole/frame-all.exr");
    }();
    for (const json& finding : oracle.at("worst")) {
        const int x = finding.at("x"), y = finding.at("y");
        EXPECT_EQ(x % 3, first.at(0));
        EXPECT_EQ(y % 3, first.at(1));
        EXPECT_EQ(std::uint32_t(ours.primitive.at(x, y)),
                  finding.at("reference").at("primitive").get<std::uint32_t>());
        const std::string command = finding.at("command");
        EXPECT_NE(command.find("two.gltf " + std::to_string(x) + " " + std::to_string(y) + " "),
                  std::string::npos);
        EXPECT_NE(command.find("--width 960 --height 540"), std::string::npos) << command;
    }
}

TEST_F(StoredFrames, FourRenderersShareOneMatrixAndPovRayPaints) {
    const Ran ran = run(folder, {"run", "two.gltf", "--width", "64", "--height", "48", "--oracle",
                                 "povray,opengl", "--evidence", "all", "--pictures"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const json view = only_view();
    EXPECT_EQ(view.at("id_agreement").at("same").size(), 4u);
    for (const json& oracle : view.at("oracles")) {
        EXPECT_EQ(oracle.at("absent"), "");
        EXPECT_EQ(oracle.at("defects"), 0);
    }
    EXPECT_GT(view.at("oracles").at(0).at("picture").at("agree").at("pixels"), 0);
    const json renderers = json::parse(folder.read("zproof-out/results.json")).at("run").at("renderers");
    ASSERT_EQ(renderers.size(), 4u);
    for (const json& renderer : renderers) EXPECT_NE(renderer.at("version"), "");
}

TEST_F(StoredFrames, OraclesAreJudgedAndCounted) {
    const Ran ran = run(folder, {"run", "two.gltf", "--width", "64", "--height", "48", "--renderer", "embree",
                                 "--oracle", "zproof", "--evidence", "all"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    const json view = only_view();
    EXPECT_EQ(view.at("candidate"), "embree");
    EXPECT_EQ(view.at("oracles").at(0).at("name"), "zproof");
    EXPECT_EQ(view.at("oracles").at(0).at("absent"), "");
    EXPECT_EQ(view.at("oracles").at(0).at("defects"), 0);
    EXPECT_EQ(view.at("id_agreement").at("same").size(), 3u);
    EXPECT_EQ(view.at("id_agreement").at("same").at(0).at(1), 64 * 48);
    EXPECT_NE(ran.out.find("zproof: 1 view, 0 defects"), std::string::npos) << ran.out;
    EXPECT_GT(folder.read("zproof-out/" + view.at("folder").get<std::string>() + "/zproof.exr").size(), 0u);
}

}  // namespace
}  // namespace zproof::test
