/// Every fault of the catalogue gets its verdict: NaN, infinities, ids out of range, frames of another size,
/// an empty frame, the reference's own frame, ...
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "cli/selftest/theatre.h"

namespace zproof::selftest {

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.sentence; }

namespace {

const Theatre& theatre_of(StageSize size) {
    static const Theatre small(StageSize::small);
    if (size == StageSize::small) return small;
    static const Theatre large(StageSize::large);
    return large;
}

class Catalogue : public testing::TestWithParam<Fault> {};

TEST_P(Catalogue, GetsItsVerdict) {
    const Trial trial = try_fault(GetParam(), theatre_of(GetParam().stage_size).stage());
    EXPECT_TRUE(trial.as_expected) << in_words(trial);
}

INSTANTIATE_TEST_SUITE_P(Selftest, Catalogue, testing::ValuesIn(catalogue()),
                         [](const auto& fault) { return fault.param.name; });

TEST(CatalogueAsAWhole, HasNoNameTwice) {
    std::set<std::string> names;
    for (const Fault& fault : catalogue()) EXPECT_TRUE(names.insert(fault.name).second) << fault.name;
}

TEST(CatalogueAsAWhole, ExpectsEveryClassThatFailsTheGate) {
    const std::vector<Fault> all = catalogue();
    for (int c = 0; c < pixel_class_count; ++c) {
        const auto injects = [&](const Fault& fault) {
            return std::ranges::count(fault.expected.classes, PixelClass(c)) > 0;
        };
        EXPECT_TRUE(passes(PixelClass(c)) || std::ranges::any_of(all, injects)) << name_of(PixelClass(c));
    }
}

TEST(CatalogueAsAWhole, InjectsWhatItSays) {
    for (const Fault& fault : catalogue()) {
        if (is_control(fault)) continue;
        const Stage stage = theatre_of(fault.stage_size).stage();
        const Frame faulty = fault.inject(stage);
        const bool same_ids = std::ranges::equal(faulty.primitive.pixels(), stage.good.primitive.pixels());
        const bool same_depths =
            std::ranges::equal(faulty.camera_depth.pixels(), stage.good.camera_depth.pixels());
        EXPECT_FALSE(same_ids && same_depths) << fault.name << " changes nothing";
    }
}

/// A frame is judged by its own promise: to be like the reference is no excuse.
TEST(EqualToReference, FailsWhereItsRendererPromisesMoreThanTheReferenceKeeps) {
    const Stage stage = theatre_of(StageSize::large).stage();
    const Verdict verdict = judge(stage.scene, stage.view, {stage.reference, stage.precision},
                                  {stage.reference, stage.reference_precision});
    EXPECT_GT(verdict.counts[std::size_t(PixelClass::wrong_depth)], 0u);
    EXPECT_EQ(verdict.adjudicated, 0u);
    EXPECT_EQ(verdict.reference_defects, 0u);
}

}  // namespace
}  // namespace zproof::selftest
