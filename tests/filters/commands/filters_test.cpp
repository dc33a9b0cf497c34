// zproof filters as a user types it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "filters/area/area_integral.h"
#include "filters/commands/arguments.h"
#include "filters/commands/command_line.h"
#include "filters/methods/catalogue.h"
#include "filters/report/json.h"
#include "filters/report/table_cells.h"
#include "filters/selftest/filter_fault.h"
#include "filters/study/claims.h"
#include "image_io/image_io.h"
#include "program/command_line/outline.h"
#include "program/usage_error.h"
#include "reports/pictures.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/scene_hash.h"
#include "scenes/view_file.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

const Words small{"filters",
                  "run",
                  "worked",
                  "--view",
                  "phi-0",
                  "--width",
                  "32",
                  "--height",
                  "32",
                  "--methods",
                  "nearest,trilinear-gl:bias=1",
                  "--flicker",
                  "1",
                  "-o",
                  "study"};

TEST(FilterChoices, AllIsTheCatalogueAndNobodyComesTwice) {
    const auto choices = filter_choices("trilinear-gl,all,sat-strips:n=16", filter_choice);
    EXPECT_EQ(choices.size(), texture::methods().size() + 1);
    EXPECT_EQ(choices.front().typed, "trilinear-gl");
    EXPECT_EQ(choices.back().texturing.options.subdivisions, 16);
    EXPECT_THROW(filter_choices("", filter_choice), UsageError);
    EXPECT_THROW(filter_choices("nearest,trilinaer-gl", filter_choice), UsageError);
}

TEST(Filters, RunWritesTheWholeStudy) {
    const Folder folder;
    const Ran ran = run(folder, small);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.out.find("worked / phi-0"), std::string::npos) << ran.out;
    EXPECT_NE(ran.err.find("[ 75%] worked / phi-0: trilinear-gl:bias=1"), std::string::npos) << ran.err;
    for (const char* file :
         {"filters.json", "filters.csv", "table.tex", "filters.html", "plots/worked-phi-0/pareto.svg",
          "plots/worked-phi-0/anisotropy.svg", "plots/worked-phi-0/angle.svg",
          "pictures/worked-phi-0/truth.exr", "pictures/worked-phi-0/nearest.exr",
          "pictures/worked-phi-0/trilinear-gl_bias_1.exr", "crops/worked-phi-0/truth.png",
          "crops/worked-phi-0/nearest.png"})
        EXPECT_TRUE(fs::exists(folder.path() / "study" / file)) << file;
    const study::StudyResults results = filters_from_json(folder.read("study/filters.json"));
    ASSERT_EQ(results.views.size(), 1u);
    EXPECT_EQ(results.views[0].first_row, 7);
    // Of rows 7 to 31; near the horizon the truth may be an estimate.
    const auto interior = study::find_score(results.views[0].methods[0], "interior")->pixels;
    EXPECT_LE(interior, 25u * 32);
    EXPECT_GT(interior, 20u * 32);
    EXPECT_EQ(read_picture(folder.path() / "study/pictures/worked-phi-0/nearest.exr").size(),
              (Resolution{32, 32}));
}

TEST(Filters, ScenesAreWrittenAsTheyAre) {
    const Folder folder;
    EXPECT_EQ(run(folder, {"filters", "scenes", "worked", "npot_plane", "-o", "out"}).exit_code, 0);
    for (const auto& [name, side] : {std::pair{"worked", 256}, std::pair{"npot_plane", 512}}) {
        const Loaded read = load_view_file(folder.path() / "out" / (std::string{name} + ".view.json"));
        const Loaded made = generate_filter_scene(name, side, side);
        EXPECT_EQ(sha256_of(read.scene), sha256_of(made.scene)) << name;
        ASSERT_EQ(read.scene.images.size(), made.scene.images.size());
        EXPECT_EQ(read.scene.images[0].texels, made.scene.images[0].texels) << name;
        ASSERT_EQ(read.views.size(), made.views.size());
        EXPECT_EQ(read.views[0].width, side);
        EXPECT_EQ(read.views[0].camera.window.top, made.views[0].camera.window.top);
    }
    const Ran unknown = run(folder, {"filters", "scenes", "tunel", "-o", "other"});
    EXPECT_EQ(unknown.exit_code, 3);
    EXPECT_NE(unknown.err.find("did you mean 'tunnel'?"), std::string::npos) << unknown.err;
    EXPECT_FALSE(fs::exists(folder.path() / "other"));
}

TEST(Filters, RegionsHaveTheSamePixelsWhateverTheTruth) {
    const Folder folder;
    std::map<std::string, std::set<std::uint64_t>> pixels_of;
    for (const auto& [truth, reconstruction] : oracle::reconstructions) {
        Words words = small;
        words[2] = "tunnel";
        words.erase(words.begin() + 3, words.begin() + 5);  // --view
        words[4] = words[6] = "16";                         // --width, --height
        words[10] = "0";                                    // --flicker
        words.insert(words.end(), {"--truth", std::string{truth}});
        ASSERT_EQ(run(folder, words).exit_code, 0);
        for (const study::ViewStudy& view : filters_from_json(folder.read("study/filters.json")).views)
            for (const study::RegionScore& score : view.methods.at(0).regions)
                if (score.region != "sampled") pixels_of[view.view + score.region].insert(score.pixels);
    }
    for (const auto& [region, pixels] : pixels_of) EXPECT_EQ(pixels.size(), 1u) << region;
}

TEST(Filters, EveryTruthIsToldInWords) {
    std::set<std::string> all;
    for (const auto& [letters, reconstruction] : oracle::reconstructions) {
        const std::string words = truth_in_words(std::string{letters});
        EXPECT_TRUE(words.starts_with("GT-" + std::string{letters} + ": the ")) << words;
        all.insert(words);
    }
    EXPECT_EQ(all.size(), oracle::reconstructions.size());
}

TEST(Filters, PhotographsAreToldApart) {
    const Folder folder;
    for (const char* place : {"one/photo.png", "two/photo.png", "other.png"}) {
        folder.write(place, "");
        write_png(folder.path() / place, Plane<Rgb8>({4, 4}, {90, 120, 200}));
    }
    Words words = small;
    words[2] = "one/photo.png";
    words[4] = "phi-0,phi-82.5";
    words.insert(words.end(), {"two/photo.png", "other.png"});
    const Ran ran = run(folder, words);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    std::set<std::string> names, files;
    std::size_t views = 0;
    for (const study::ViewStudy& view : filters_from_json(folder.read("study/filters.json")).views) {
        names.insert(view.scene);
        files.insert(view.truth_file);
        ++views;
    }
    EXPECT_EQ(names, (std::set<std::string>{"photo.png", "two/photo.png", "other.png"}));
    EXPECT_EQ(files.size(), views);
    for (const std::string& name : names)
        EXPECT_NE(folder.read("study/filters.csv").find("\n" + name + ","), std::string::npos);
}

TEST(Filters, SamplersOfOthersAreMethodsOfAStudy) {
    const Folder folder;
    Words words = small;
    words[std::size_t(std::ranges::find(words, "--methods") - words.begin()) + 1] =
        "trilinear-oiio:mip=box,oiio-trilinear,oiio-aniso:max-anisotropy=4";
    const Ran ran = run(folder, words);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const study::StudyResults results = filters_from_json(folder.read("study/filters.json"));
    ASSERT_EQ(results.views.at(0).methods.size(), 3u);
    const Picture reference =
                      read_picture(folder.path() / "study/pictures/worked-phi-0/trilinear-oiio_mip_box.exr"),
                  theirs = read_picture(folder.path() / "study/pictures/worked-phi-0/oiio-trilinear.exr");
    for (int y = 7; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            EXPECT_NEAR(reference.at(x, y).g, theirs.at(x, y).g, 1e-3) << x << " " << y;
}

TEST(Filters, TableAndFigureReadAStudyAgain) {
    const Folder folder;
    ASSERT_EQ(run(folder, small).exit_code, 0);
    const Ran table = run(folder, {"filters", "table", "study", "--region", "all"});
    EXPECT_EQ(table.exit_code, 0) << table.err;
    EXPECT_NE(table.out.find("region 'all' (1,024 pixels)"), std::string::npos) << table.out;
    EXPECT_EQ(run(folder, {"filters", "table", "study", "--csv"}).out, folder.read("study/filters.csv"));
    EXPECT_EQ(run(folder, {"filters", "table", "study", "--latex"}).out, folder.read("study/table.tex"));
    fs::remove(folder.path() / "study/filters.html");
    const Ran figure =
        run(folder, {"filters", "figure", "study", "--crop", "2,3,10,12", "--methods", "nearest"});
    EXPECT_EQ(figure.exit_code, 0) << figure.err;
    EXPECT_NE(folder.read("study/filters.html").find("Pixels 2,3,10,12"), std::string::npos);
}

TEST(Filters, WhatIsMistypedIsNamedWithWhatIsNear) {
    const Folder folder;
    const auto refused = [&](const Words& words, const std::string& said, int status = 2) {
        const Ran ran = run(folder, words);
        EXPECT_EQ(ran.exit_code, status) << ran.err;
        EXPECT_NE(ran.err.find(said), std::string::npos) << ran.err;
    };
    refused(
        {"filters"},
        "'run', 'list', 'scenes', 'reproduce', 'table', 'figure', 'check', 'explain', 'normals' or 'crow' "
        "expected");
    refused({"filters", "run", "wroked"}, "did you mean 'worked'?", 3);
    refused({"filters", "run", "worked", "--methods", "nearst"}, "did you mean 'nearest'?");
    refused({"filters", "run", "worked", "--truth", "X"}, "--truth");
    refused({"filters", "run", "worked", "--view", "phi-1", "--methods", "nearest"}, "it has phi-0, phi-7.5");
    refused({"filters", "figure", "study", "--crop", "1,2,3"}, "expected X,Y,WIDTH,HEIGHT");
    refused({"filters", "check"}, "METHODS");
    refused({"filters", "check", "oiio-aniso", "worked"}, "draws only in 'zproof filters run'");
    refused({"filters", "run", "worked", "--methods", "oiio-aniso:bias=1"}, "one sets only max-anisotropy");
    refused({"filters", "check", "nearst", "worked"}, "did you mean 'nearest'?");
    refused({"filters", "check", "nearest", "worked", "--precision", "lod_bit=8"},
            "did you mean 'lod_bits'?");
    refused({"filters", "check", "nearest", "worked", "--precision", "gpo"}, "did you mean 'gpu'?");
    refused({"filters", "check", "nearest", "worked", "--precision", "lod_bits=6,gpu"},
            "a preset comes first, then keys: gpu,lod_bits=6");
    refused({"filters", "check", "nearest", "worked", "--precision", "lod_bits=x"}, "from 0 to 1000");
    refused({"filters", "check", "nearest,bilinear", "worked", "--picture", "a.exr"},
            "one method is expected");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Filters, CheckComparesOurPicturesWithTheirReference) {
    const Folder folder;
    const Ran ran = run(folder, {"filters", "check", "trilinear-gl:bias=0.5,sat-moment", "worked", "--view",
                                 "phi-45", "--width", "48", "--height", "48"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_NE(ran.out.find("passed  worked / phi-45: sat-moment: no pixel of 2304 outside"),
              std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("2 pictures: 2 within the reference of their method, 0 not"), std::string::npos)
        << ran.out;
}

/// Row 34 shows the sky and row 35 the plane: one 2 x 2 pixels of the driver's. Its work must not grow with
/// what lies between them.
TEST(Filters, AnisotropicSamplerOfTheDriverEndsAtAHorizon) {
    const Folder folder;
    const Ran ran = run(folder, {"filters", "run", "worked", "--view", "phi-0", "--width", "192", "--height",
                                 "192", "--methods", "opengl-aniso", "--flicker", "0", "-o", "study"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
}

/// A picture is admissible by its own method, and by a method whose promise is wide enough, and by no other.
TEST(Filters, CheckComparesAnyPictureWithItsReference) {
    const Folder folder;
    ASSERT_EQ(run(folder, small).exit_code, 0);
    const auto judged = [&](const std::string& method, const std::string& precision) {
        return run(folder,
                   {"filters", "check", method, "worked", "--view", "phi-0", "--width", "32", "--height",
                    "32", "--picture", "study/pictures/worked-phi-0/nearest.exr", "--precision", precision});
    };
    EXPECT_EQ(judged("nearest", "colour_bits=24").exit_code, 0);
    const Ran other = judged("bilinear", "colour_bits=24");
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.out.find("FAILED  worked / phi-0: bilinear: "), std::string::npos) << other.out;
    EXPECT_NE(other.out.find("; worst at ("), std::string::npos) << other.out;
    EXPECT_EQ(judged("bilinear", "place_bits=0").exit_code, 0);
    EXPECT_EQ(judged("bilinear", "gpu,arithmetic_bits=53").exit_code, 1);
    const Ran open = judged("bilinear", "gpu");
    EXPECT_EQ(open.exit_code, 3) << "corners a thousand units away: 24 bits promise a texel";
    EXPECT_NE(open.out.find("nothing worked / phi-0: bilinear: "), std::string::npos) << open.out;
    EXPECT_NE(open.out.find("where the renderer is so good, promise arithmetic_bits=53"), std::string::npos)
        << open.out;
    EXPECT_NE(judged("nearest", "colour_bits=24").out.find("LOD not told"), std::string::npos);
    EXPECT_EQ(run(folder, {"filters", "check", "nearest", "worked", "--picture",
                           "study/pictures/worked-phi-0/nearest.exr", "--width", "32", "--height", "32"})
                  .exit_code,
              2);
}

/// Eight bits of sRGB as most programs write them.
TEST(Filters, CheckReadsAPngThatPromisesItsCodes) {
    const Folder folder;
    ASSERT_EQ(run(folder, small).exit_code, 0);
    const fs::path made = folder.path() / "study/pictures/worked-phi-0/trilinear-gl_bias_1.exr";
    write_png(folder.path() / "mine.png", picture_of_light(read_picture(made)));
    const auto judged = [&](const std::string& method, const std::string& precision) {
        return run(folder, {"filters", "check", method, "worked", "--view", "phi-0", "--width", "32",
                            "--height", "32", "--picture", "mine.png", "--precision", precision});
    };
    const Ran right = judged("trilinear-gl:bias=1", "output=srgb8");
    EXPECT_EQ(right.exit_code, 0) << right.out << right.err;
    EXPECT_EQ(judged("trilinear-gl:bias=1", "colour_bits=24").exit_code, 1);
    EXPECT_EQ(judged("trilinear-gl", "output=srgb8").exit_code, 1);
}

TEST(Filters, WordsAboutAStudyAreHeldAgainstIt) {
    const Folder folder;
    ASSERT_EQ(run(folder, small).exit_code, 0);
    const Ran region = run(folder, {"filters", "table", "study", "--region", "interor"});
    EXPECT_EQ(region.exit_code, 2);
    EXPECT_NE(region.err.find("did you mean 'interior'?"), std::string::npos) << region.err;
    const Ran method = run(folder, {"filters", "figure", "study", "--methods", "nearst"});
    EXPECT_EQ(method.exit_code, 2);
    EXPECT_NE(method.err.find("did you mean 'nearest'?"), std::string::npos) << method.err;
    EXPECT_EQ(run(folder, {"filters", "figure", "study", "--crop", "99,0,5,5"}).exit_code, 3);
    EXPECT_EQ(run(folder, {"filters", "table", "nowhere"}).exit_code, 3);
}

/// A model without a texture has nothing to filter.
TEST(Filters, NothingToStudyIsNotASuccess) {
    const Folder folder;
    folder.write("plain.gltf", one_triangle());
    const Ran ran = run(folder, {"filters", "run", "plain.gltf", "--methods", "nearest", "--width", "16",
                                 "--height", "16", "-o", "study"});
    EXPECT_EQ(ran.exit_code, 4) << ran.err;
    EXPECT_NE(ran.err.find("no pixel of these scenes shows a texture"), std::string::npos) << ran.err;
}

TEST(Filters, ListNamesMethodsMetricsAndScenes) {
    const Folder folder;
    const Ran ran = run(folder, {"filters", "list"});
    EXPECT_EQ(ran.exit_code, 0);
    for (const char* name :
         {"  nearest ", "  ewa-true ", "  psnr ", "  flip ", "  worked ", "  tilted_quads "})
        EXPECT_NE(ran.out.find(name), std::string::npos) << name;
}

TEST(Filters, CrowIsOnePageThatAnswersTheLecturesQuestions) {
    const Folder folder;
    const Ran ran = run(folder, {"filters", "crow", "--width", "32", "--height", "32", "-o", "crow"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const std::string page = folder.read("crow/crow1984.html");
    for (const char* words :
         {"5x5 neighborhood", "fractional distance", "non-square region", "0.3219", "sat-affine"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
    EXPECT_EQ(page.find("http:"), std::string::npos);
    EXPECT_EQ(page.find("https:"), std::string::npos);
}

/// worked has 512 x 512 texels. A chain of grey levels is one's own: a picture of them keeps to itself, not
/// to zproof's.
TEST(Filters, LevelsOfOnesOwnAreReadFromFiles) {
    const Folder folder;
    int level = 1;
    for (int side = 256; side >= 1; side /= 2) {
        const std::string name = "grey_" + std::to_string(level++) + ".png";
        write_png(folder.path() / name, Plane<Rgb8>(Resolution{side, side}, Rgb8{128, 128, 128}));
    }
    const std::string own = "trilinear-gl:levels=" + (folder.path() / "grey_{level}.png").string();
    const auto checked = [&](const std::string& word) {
        return run(folder, {"filters", "check", word, "worked", "--view", "phi-0", "--width", "48",
                            "--height", "48"});
    };
    EXPECT_EQ(checked(own).exit_code, 0) << checked(own).err;
    const Ran none = checked("trilinear-gl:levels=grey.png");
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_NE(none.err.find("levels: expected a file with mip levels, or a name with {level} in it"),
              std::string::npos)
        << none.err;
    write_png(folder.path() / "grey_2.png", Plane<Rgb8>(Resolution{100, 128}, Rgb8{128, 128, 128}));
    const Ran odd = checked(own);
    EXPECT_EQ(odd.exit_code, 3);
    EXPECT_NE(odd.err.find("mip level 2 that is given has 100 x 128 texels: expected 128 x 128"),
              std::string::npos)
        << odd.err;
}

TEST(Filters, SelftestTellsEveryFaultAndEndsWithZero) {
    const Folder folder;
    const Ran ran = run(folder, {"filters", "selftest"});
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(ran.err, "");
    const std::size_t tests = selftest::filter_faults().size() + texture::methods().size();
    EXPECT_EQ(std::size_t(std::ranges::count(ran.out, '\n')), tests + 1) << ran.out;
    EXPECT_NE(ran.out.find("\nthe gate works: "), std::string::npos) << ran.out;
}

TEST(Filters, HaveExamplesOfKnownCommandsOnly) {
    const Folder folder;
    std::set<std::string> paths;
    const OutlineCommand outline = outline_from(run(folder, {"filters", "outline"}).out);
    for (const OutlineCommand& command : outline.commands) paths.insert(command.path);
    for (const Example& example : filters_program::examples())
        EXPECT_TRUE(example.command == "filters" || paths.contains(std::string{example.command}))
            << example.line;
}

}  // namespace
}  // namespace zproof::test
