// Pictures of other renderers in zproof filters, and what many textures say together.
#include <gtest/gtest.h>

#include <algorithm>

#include "filters/commands/view_evidence.h"
#include "filters/report/json.h"
#include "filters/study/claims.h"
#include "image_io/image_io.h"
#include "math/sha256.h"
#include "program/usage_error.h"
#include "tests/cli/program.h"

namespace zproof::test {
namespace {

const Words small{"filters",          "run",       "--width", "32", "--height", "32", "--methods",
                  "nearest,bilinear", "--flicker", "1",       "-o", "study"};

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

double psnr(const study::StudyResults& results, std::size_t view, std::size_t method) {
    return study::value_of(results, results.views.at(view).methods.at(method), "interior", "psnr");
}

/// A study of one view, whose pictures then come back as those of strangers.
class FilterPictures : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_EQ(run(folder_, with(small, {"worked", "--view", "phi-0"})).exit_code, 0);
        std::filesystem::rename(folder_.path() / "study", folder_.path() / "ours");
    }

    const std::string theirs_ = "ours/pictures/worked-phi-0/bilinear.exr";
    Folder folder_;
};

TEST_F(FilterPictures, StandInTheTableBesideTheMethods) {
    const Ran ran = run(folder_, with(small, {"worked", "--view", "phi-0", "--picture", "theirs=" + theirs_,
                                              "--picture", "program=cp " + theirs_ + " {out}"}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const study::StudyResults results = filters_from_json(folder_.read("study/filters.json"));
    ASSERT_EQ(results.views.at(0).methods.size(), 4u);
    EXPECT_EQ(psnr(results, 0, 2), psnr(results, 0, 1));
    EXPECT_EQ(psnr(results, 0, 3), psnr(results, 0, 1));
    EXPECT_EQ(results.views[0].methods[2].flicker.steps, 0) << "a file has one view";
    EXPECT_EQ(results.views[0].methods[3].flicker.steps, 1) << "a program draws further views";
    EXPECT_NE(results.methods[2].source.find(theirs_), std::string::npos);
    EXPECT_NE(ran.out.find("theirs"), std::string::npos) << ran.out;
    EXPECT_TRUE(
        std::ranges::equal(read_picture(folder_.path() / "study/pictures/worked-phi-0/theirs.exr").pixels(),
                           read_picture(folder_.path() / theirs_).pixels()));
}

/// The study goes on without it, and says so.
TEST_F(FilterPictures, ThatAreMissingLeaveTheRest) {
    for (const std::string& word : {std::string{"nowhere.exr"}, std::string{"ours/filters.json"},
                                    std::string{"echo broken >&2; false {out}"}}) {
        const Ran ran =
            run(folder_, with(small, {"worked", "--view", "phi-0", "--picture", "theirs=" + word}));
        EXPECT_EQ(ran.exit_code, 3) << word;
        EXPECT_NE(ran.err.find("worked / phi-0: theirs: "), std::string::npos) << ran.err;
        const study::StudyResults results = filters_from_json(folder_.read("study/filters.json"));
        EXPECT_EQ(results.views.at(0).methods.size(), 2u);
        ASSERT_EQ(results.views.at(0).missing.size(), 1u);
        EXPECT_NE(folder_.read("study/filters.html").find("has no picture of this view"), std::string::npos);
    }
}

TEST_F(FilterPictures, OfAnotherSizeAreRefusedWithBothSizes) {
    const Ran ran =
        run(folder_, {"filters", "run", "worked", "--view", "phi-0", "--width", "48", "--height", "32",
                      "--methods", "nearest", "--picture", "theirs=" + theirs_, "-o", "study"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_NE(ran.err.find("32 x 32 pixels; the view 'phi-0' has 48 x 32"), std::string::npos) << ran.err;
}

TEST_F(FilterPictures, AreFoundByTheNamesOfSceneAndView) {
    std::filesystem::copy_file(folder_.path() / theirs_, folder_.path() / "worked_phi-0.exr");
    const Ran ran =
        run(folder_, with(small, {"worked", "--view", "phi-0", "--picture", "theirs={scene}_{view}.exr"}));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
}

TEST_F(FilterPictures, HaveNamesOfTheirOwnAndAFileForEachView) {
    const auto refused = [&](const Words& words, const std::string& why) {
        const Ran ran = run(folder_, with(small, words));
        EXPECT_EQ(ran.exit_code, 2) << ran.err;
        EXPECT_NE(ran.err.find(why), std::string::npos) << ran.err;
    };
    refused({"worked", "--picture", "a.exr"}, "expected NAME=FILE");
    refused({"worked", "--picture", "a b=a.exr"}, "a name has letters");
    refused({"worked", "--picture", "nearest=a.exr"}, "is taken");
    refused({"worked", "--picture", "a=a.exr", "--picture", "a=b.exr"}, "is taken");
    refused({"worked", "--picture", "bilinear-error=a.exr"}, "is taken");
    refused({"worked", "--picture", "mine-permitted=a.exr"}, "is taken");
    refused({"worked", "--picture", "a=a.exr"}, "put {view} into its name");
    refused({"worked", "tunnel", "--picture", "a={view}.exr"}, "put {scene} into its name");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "study"));
}

/// What the planes hold is read by tests/viewer/filters_test.mjs.
TEST_F(FilterPictures, ShowWhatTheMethodPermitsThatTheyClaimToBe) {
    const Ran ran = run(
        folder_, with(small, {"worked", "--view", "phi-0", "--evidence", "--picture", "theirs=" + theirs_,
                              "--claim", "theirs=trilinear-gl:bias=0.5", "--precision", "gpu,lod_bits=6"}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const std::string permitted = folder_.read("study/pictures/worked-phi-0/theirs-permitted.exr");
    for (const char* words : {"least.R", "greatest.B", "outside", "zproof:claim", "trilinear-gl:bias=0.5",
                              "zproof:promise", "gpu,lod_bits=6"})
        EXPECT_NE(permitted.find(words), std::string::npos) << words;
    const study::StudyResults results = filters_from_json(folder_.read("study/filters.json"));
    EXPECT_EQ(results.methods.at(2).source, "read from: " + theirs_ +
                                                "; claims to be of trilinear-gl:bias=0.5, promising "
                                                "gpu,lod_bits=6");
    EXPECT_FALSE(
        std::filesystem::exists(folder_.path() / "study/pictures/worked-phi-0/nearest-permitted.exr"));
    const auto& claim = results.views.at(0).methods.at(2).claim;
    ASSERT_TRUE(claim);
    EXPECT_EQ(claim->method, "trilinear-gl:bias=0.5");
    EXPECT_EQ(claim->promise, "gpu,lod_bits=6");
    EXPECT_GT(claim->pixels_outside, 0u);
    const std::string words = "theirs has " + std::to_string(claim->pixels_outside) +
                              " pixels outside what trilinear-gl:bias=0.5 permits, promising gpu,lod_bits=6";
    EXPECT_NE(ran.out.find("worked / phi-0: " + words), std::string::npos) << ran.out;
    EXPECT_NE(folder_.read("study/filters.html").find(words), std::string::npos);
}

TEST_F(FilterPictures, AreInspectedInABoxThatTheViewHolds) {
    const Words worked = with(small, {"worked", "--view", "phi-0", "--inspect"});
    EXPECT_EQ(run(folder_, with(worked, {"24,31,8,1"})).exit_code, 0);
    const std::string header = folder_.read("study/pictures/worked-phi-0/planes.zvp").substr(0, 8192);
    EXPECT_NE(header.find("\"inspected.nearest.31\""), std::string::npos);
    EXPECT_EQ(header.find("\"inspected.nearest.30\""), std::string::npos);
    const auto refused = [&](const std::string& box, const std::string& why) {
        const Ran ran = run(folder_, with(worked, {box}));
        EXPECT_EQ(ran.exit_code, 2) << ran.err;
        EXPECT_NE(ran.err.find(why), std::string::npos) << ran.err;
    };
    refused("24,31,9,1", "reaches beyond the view 'phi-0', which has 32 x 32 pixels");
    refused("24,31,8,2", "reaches beyond");
    refused("24,31,8", "--inspect: expected X,Y,WIDTH,HEIGHT");
}

TEST(InspectedBox, HasAtMostTwoToTheFifteenPixelsEachMethodCounted) {
    View view;
    view.width = view.height = 512;
    EXPECT_NO_THROW(refuse_unfit_box({0, 0, 256, 128}, 1, view));
    EXPECT_NO_THROW(refuse_unfit_box({256, 480, 256, 32}, 4, view));
    EXPECT_THROW(refuse_unfit_box({0, 0, 331, 99}, 1, view), UsageError) << "one more";
    EXPECT_THROW(refuse_unfit_box({0, 0, 257, 128}, 1, view), UsageError);
}

TEST_F(FilterPictures, ClaimOnlyWhatCanBeChecked) {
    const auto refused = [&](const Words& words, const std::string& why) {
        const Ran ran =
            run(folder_,
                with(small, with({"worked", "--view", "phi-0", "--picture", "theirs=" + theirs_}, words)));
        EXPECT_EQ(ran.exit_code, 2) << ran.err;
        EXPECT_NE(ran.err.find(why), std::string::npos) << ran.err;
    };
    refused({"--claim", "bilinear"}, "expected NAME=METHOD");
    refused({"--claim", "ours=bilinear"}, "with the name of a --picture");
    refused({"--claim", "theirs=bilinearr"}, "bilinearr");
    refused({"--claim", "theirs=oiio-aniso"}, "oiio-aniso");
    refused({"--claim", "theirs=bilinear", "--claim", "theirs=nearest"}, "has a claim already");
    refused({"--precision", "gpu"}, "together with --claim");
    refused({"--claim", "theirs=bilinear", "--precision", "gpuu"}, "did you mean 'gpu'?");
}

/// The nearest pixel at which nearest and bilinear show different colours.
std::string telling_pixel(const Picture& nearest, const Picture& bilinear) {
    for (int y = nearest.size().height - 1; y >= 0; --y)
        for (int x = 0; x < nearest.size().width; ++x)
            if (std::abs(nearest.at(x, y).g - bilinear.at(x, y).g) > 0.1f)
                return std::to_string(x) + "," + std::to_string(y);
    return "none";
}

TEST_F(FilterPictures, AreExplainedAtAPixelBesideWhatTheirClaimPermits) {
    const auto home = folder_.path() / "ours/pictures/worked-phi-0";
    const std::string pixel =
        telling_pixel(read_picture(home / "nearest.exr"), read_picture(home / "bilinear.exr"));
    const auto explained = [&](const Words& words) {
        return run(folder_, with({"filters", "explain", "worked", "--view", "phi-0", "--width", "32",
                                  "--height", "32", "--pixel", pixel},
                                 words));
    };
    const Ran right = explained({"--method", "bilinear", "--picture", theirs_});
    EXPECT_EQ(right.exit_code, 0) << right.err;
    EXPECT_NE(right.out.find("the picture is within what bilinear permits\n"), std::string::npos)
        << right.out;
    EXPECT_NE(right.out.find("  taps "), std::string::npos) << right.out;
    const Ran wrong =
        explained({"--method", "nearest", "--picture", theirs_, "--precision", "lod_bits=6", "-q"});
    EXPECT_EQ(wrong.exit_code, 1) << wrong.err;
    EXPECT_NE(wrong.out.find("the picture is outside by 0."), std::string::npos) << wrong.out;
    EXPECT_NE(wrong.out.find(" of what nearest permits, promising lod_bits=6\n"), std::string::npos)
        << wrong.out;
    EXPECT_EQ(
        explained({"--method", "nearest", "--picture", theirs_, "--precision", "weight_bits=0"}).exit_code,
        1);
    EXPECT_EQ(explained({"--method", "nearest", "--precision", "gpu"}).exit_code, 2);
    EXPECT_EQ(explained({"--method", "nearest,bilinear", "--picture", theirs_}).exit_code, 2);
    EXPECT_EQ(explained({"--method", "oiio-aniso", "--picture", theirs_}).exit_code, 2);
    EXPECT_EQ(explained({"--method", "nearest", "--picture", "nowhere.exr"}).exit_code, 3);
}

/// The input's hash is that of the .glb that anybody can write and hash.
TEST_F(FilterPictures, SayInTheirHeadersWhereTheyComeFrom) {
    const std::string truth = folder_.read("ours/pictures/worked-phi-0/truth.exr");
    ASSERT_EQ(run(folder_, {"filters", "scenes", "worked", "-o", "scenes"}).exit_code, 0);
    for (const std::string& words :
         {std::string{"zproof:command"}, std::string{"zproof filters run"}, std::string{"zproof:commit"},
          sha256_of(folder_.read("scenes/worked.glb"))})
        EXPECT_NE(truth.find(words), std::string::npos) << words;
}

TEST(ViewFiles, KeepTheirSizeAndSaySoWhereAnotherOneIsTyped) {
    const Folder folder;
    ASSERT_EQ(run(folder, {"filters", "scenes", "worked", "-o", "scenes"}).exit_code, 0);
    const auto explained = [&](const std::string& scene, const Words& more) {
        return run(folder, with({"filters", "explain", scene, "--view", "phi-0", "--pixel", "9,200",
                                 "--method", "nearest"},
                                more));
    };
    const std::string words = "the view 'phi-0' states its own size, 256 x 256";
    const Ran other = explained("scenes/worked.view.json", {"--width", "300"});
    EXPECT_EQ(other.exit_code, 0) << other.err;
    EXPECT_NE(other.err.find(words), std::string::npos) << other.err;
    EXPECT_EQ(explained("scenes/worked.view.json", {"--width", "256", "--height", "256"}).err, "");
    EXPECT_EQ(explained("scenes/worked.view.json", {"--height", "300", "-q"}).err, "");
    EXPECT_EQ(explained("worked", {"--width", "300"}).err, "") << "a scene of its own has any size";
}

/// Read back as pictures: the error is picture less truth.
TEST(FilterEvidence, HoldsTheErrorOfEveryPixel) {
    const Folder folder;
    ASSERT_EQ(run(folder, with(small, {"worked", "--view", "phi-0", "--evidence"})).exit_code, 0);
    const auto home = folder.path() / "study/pictures/worked-phi-0";
    const Picture truth = read_picture(home / "truth.exr"), drawn = read_picture(home / "bilinear.exr"),
                  error = read_picture(home / "bilinear-error.exr");
    for (std::size_t i = 0; i < truth.pixels().size(); ++i)
        ASSERT_EQ(error.pixels()[i].g, drawn.pixels()[i].g - truth.pixels()[i].g) << i;
    const std::string surface = folder.read("study/pictures/worked-phi-0/surface.exr");
    for (const char* channel : {"half_width", "du_dx", "lod", "region", "zproof:regions", "zproof:command"})
        EXPECT_NE(surface.find(channel), std::string::npos) << channel;
}

TEST(PooledTable, ComparesMethodsOverTextures) {
    const Folder folder;
    ASSERT_EQ(run(folder, with(small, {"checker_plane", "tunnel"})).exit_code, 0);
    EXPECT_NE(folder.read("study/filters.html").find("bootstrap over textures"), std::string::npos);
    const Ran table =
        run(folder, {"filters", "table", "study", "--pooled", "--columns", "rmse", "--baseline", "nearest"});
    ASSERT_EQ(table.exit_code, 0) << table.err;
    EXPECT_NE(table.out.find("rmse, mean over 2 textures"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("less nearest"), std::string::npos) << table.out;
    const Ran csv = run(folder, {"filters", "table", "study", "--pooled", "--csv"});
    EXPECT_EQ(csv.out, folder.read("study/pooled.csv"));
    EXPECT_EQ(run(folder, {"filters", "table", "study", "--pooled", "--baseline", "nearst"}).exit_code, 2);
    EXPECT_EQ(run(folder, {"filters", "table", "study", "--baseline", "nearest"}).exit_code, 2);
}

TEST(FilterTable, ShowsTheColumnsThatOneWantsTheBestFirst) {
    const Folder folder;
    ASSERT_EQ(run(folder, with(small, {"worked", "--view", "phi-0"})).exit_code, 0);
    const Ran table =
        run(folder, {"filters", "table", "study", "--columns", "psnr,texels", "--sort", "psnr"});
    ASSERT_EQ(table.exit_code, 0) << table.err;
    EXPECT_NE(table.out.find("rank  method     psnr  texels\n"), std::string::npos) << table.out;
    EXPECT_LT(table.out.find("bilinear"), table.out.find("nearest")) << table.out;
    const Ran unknown = run(folder, {"filters", "table", "study", "--columns", "psnrr"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("did you mean 'psnr'?"), std::string::npos) << unknown.err;
    const Ran latex = run(folder, {"filters", "table", "study", "--columns", "psnr", "--latex"});
    EXPECT_NE(latex.out.find("\\begin{tabular*}{\\textwidth}"), std::string::npos) << latex.out;
}

}  // namespace
}  // namespace zproof::test
