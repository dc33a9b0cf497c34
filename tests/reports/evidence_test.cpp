#include "reports/evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include "image_io/image_io.h"
#include "reports/pictures.h"
#include "tests/reports/sample.h"

namespace zproof {

/// Cell by cell, each by itself.
std::string expected_row(const Finding& f) {
    std::string row;
    const auto add = [&](auto value) {
        std::array<char, 32> digits;
        row.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr) +=
            ',';
    };
    const auto add_real = [&](auto value) { std::isnan(value) ? void(row += "nan,") : add(value); };
    const auto add_id = [&](PrimitiveId id) {
        id == PrimitiveId::none ? void(row += "none,") : add(std::uint32_t(id));
    };
    add(f.x), add(f.y);
    row.append(name_of(f.verdict)) += ',';
    add_id(f.candidate.primitive), add_id(f.reference.primitive);
    add_real(f.candidate.camera_depth), add_real(f.reference.camera_depth), add_real(f.eps_px);
    add_real(f.candidate_depth.low), add_real(f.candidate_depth.truth), add_real(f.candidate_depth.high);
    add_real(f.error_over_bound);
    row.pop_back();
    return row;
}

TEST(Evidence, CsvHoldsEveryFinding) {
    std::ostringstream out;
    write_findings(out, sample_view().verdict);
    EXPECT_EQ(
        out.str(),
        "x,y,class,candidate_id,reference_id,candidate_depth,reference_depth,eps_px,depth_low,depth_truth,"
        "depth_high,error_over_bound\n"
        "6,1,hole,none,1,inf,0.1,0.001953225,nan,nan,nan,nan\n"
        "2,3,edge,16777217,0,2.2,2.2,0.002,2.1,2.2,2.3,0.5\n");
}

TEST(Evidence, FramesComeBackBitForBit) {
    const TestFolder run;
    const SampleView sample = sample_view();
    write_sample_evidence(run.path() / "scenes/a");
    const Frame candidate = read_frame(run.path() / "scenes/a/candidate.exr");
    const Frame reference = read_frame(run.path() / "scenes/a/reference.exr");
    EXPECT_TRUE(std::ranges::equal(candidate.primitive.pixels(), sample.candidate.primitive.pixels()));
    EXPECT_TRUE(std::ranges::equal(candidate.camera_depth.pixels(), sample.candidate.camera_depth.pixels()));
    EXPECT_TRUE(std::ranges::equal(reference.primitive.pixels(), sample.reference.primitive.pixels()));
}

TEST(Evidence, IsComplete) {
    const TestFolder run;
    write_sample_evidence(run.path());
    EXPECT_EQ(content_of(run.path() / "view.webp").substr(8, 4), "WEBP");
    EXPECT_TRUE(content_of(run.path() / "view-large.jpg").starts_with("\xff\xd8\xff"));
    for (const std::string name : {"id", "reference-id", "depth", "class"})
        for (const std::string kind : {".png", "-small.png"})
            EXPECT_TRUE(content_of(run.path() / (name + kind)).starts_with("\x89PNG")) << name << kind;
    EXPECT_TRUE(content_of(run.path() / "findings.csv").starts_with("x,y,class,"));
}

TEST(Evidence, PicturesAreThoseOfTheFrames) {
    const TestFolder run;
    const SampleView sample = sample_view();
    Frame candidate({1100, 300}), reference({1100, 300});
    for (std::size_t i = 0; i < candidate.primitive.pixels().size(); ++i) {
        candidate.primitive.pixels()[i] = PrimitiveId(std::uint32_t(i / 37));
        candidate.camera_depth.pixels()[i] = 1 + float(i % 1000);
        reference.primitive.pixels()[i] = PrimitiveId(std::uint32_t(i / 39));
    }
    write_view_evidence(run.path(), candidate, reference, sample.verdict);
    const auto expect = [&](const std::string& name, const Plane<Rgb8>& picture) {
        write_png(run.path() / "expected.png", picture);
        EXPECT_EQ(content_of(run.path() / name), content_of(run.path() / "expected.png")) << name;
    };
    const Plane<Rgb8> ids = picture_of_ids(candidate.primitive), theirs = picture_of_ids(reference.primitive),
                      depths = picture_of_depths(candidate.camera_depth);
    expect("id.png", ids);
    expect("id-small.png", thinned(ids, 3));
    expect("reference-id.png", theirs);
    expect("reference-id-small.png", thinned(theirs, 3));
    expect("depth.png", depths);
    expect("depth-small.png", thinned(depths, 3));
}

/// Cells like those above them, and unlike, in files of several pieces.
TEST(Evidence, CsvNumbersReadBackToTheSameBits) {
    Verdict verdict;
    std::mt19937_64 random(5);
    double value = 1;
    for (int i = 0; i < 70'000; ++i) {
        if (random() % 3 == 0) value = std::bit_cast<double>(random());
        Finding f;
        f.x = i % 1920, f.y = i / 1920, f.verdict = PixelClass::edge;
        f.candidate = {PrimitiveId(std::uint32_t(random() % 9)), i % 2 ? float(value) : 0.1f};
        f.eps_px = value, f.error_over_bound = i % 3 ? 0.25 : -value;
        f.candidate_depth = {i % 5 ? 0.0 : -0.0, value, std::abs(value)};
        verdict.findings.push_back(f);
    }
    std::ostringstream out;
    write_findings(out, verdict);
    std::istringstream rows(out.str());
    std::string row;
    std::getline(rows, row);
    for (const Finding& f : verdict.findings) {
        ASSERT_TRUE(std::getline(rows, row));
        ASSERT_EQ(row, expected_row(f));
    }
    EXPECT_FALSE(std::getline(rows, row));
}

TEST(Evidence, AFolderThatCannotBeMadeIsNamed) {
    const TestFolder run;
    std::ofstream(run.path() / "taken") << "a file";
    try {
        write_view_summary(run.path() / "taken/scene", Plane<Rgb8>({4, 4}), sample_view().verdict);
        FAIL() << "no error";
    } catch (const ReportError& e) {
        EXPECT_NE(std::string(e.what()).find("taken/scene"), std::string::npos) << e.what();
    }
}

}  // namespace zproof
