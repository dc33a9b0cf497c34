#include "reports/evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "frame/exr.h"
#include "tests/reports/sample.h"

namespace zproof {

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
    const TemporaryFolder run;
    const SampleView sample = sample_view();
    write_view_evidence(run.path() / "scenes/a", sample.candidate, sample.reference, sample.verdict);
    const Frame candidate = read_exr(run.path() / "scenes/a/candidate.exr");
    const Frame reference = read_exr(run.path() / "scenes/a/reference.exr");
    EXPECT_TRUE(std::ranges::equal(candidate.primitive.pixels(), sample.candidate.primitive.pixels()));
    EXPECT_TRUE(std::ranges::equal(candidate.camera_depth.pixels(), sample.candidate.camera_depth.pixels()));
    EXPECT_TRUE(std::ranges::equal(reference.primitive.pixels(), sample.reference.primitive.pixels()));
}

TEST(Evidence, IsComplete) {
    const TemporaryFolder run;
    const SampleView sample = sample_view();
    write_view_evidence(run.path(), sample.candidate, sample.reference, sample.verdict);
    for (const std::string name : {"id", "reference-id", "depth", "class"})
        for (const std::string kind : {".png", "-small.png"})
            EXPECT_TRUE(content_of(run.path() / (name + kind)).starts_with("\x89PNG")) << name << kind;
    EXPECT_TRUE(content_of(run.path() / "findings.csv").starts_with("x,y,class,"));
}

TEST(Evidence, AFolderThatCannotBeMadeIsNamed) {
    const TemporaryFolder run;
    std::ofstream(run.path() / "taken") << "a file";
    const SampleView sample = sample_view();
    try {
        write_view_evidence(run.path() / "taken/scene", sample.candidate, sample.reference, sample.verdict);
        FAIL() << "no error";
    } catch (const ReportError& e) {
        EXPECT_NE(std::string(e.what()).find("taken/scene"), std::string::npos) << e.what();
    }
}

}  // namespace zproof
