/// Every fault of the catalogue gets its verdict: NaN, infinities, ids out of range, frames of another size,
/// an empty frame, the reference's own frame, ...
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "compare/adjudicate/unproven_pixels.h"
#include "selftest/test_scene.h"

namespace zproof::selftest {

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.sentence; }

namespace {

const TestScene& test_scene_of(FixtureSize size) {
    static const TestScene small(FixtureSize::small);
    if (size == FixtureSize::small) return small;
    static const TestScene large(FixtureSize::large);
    return large;
}

class Catalogue : public testing::TestWithParam<Fault> {};

TEST_P(Catalogue, GetsItsVerdict) {
    const FaultResult result = try_fault(GetParam(), test_scene_of(GetParam().fixture_size).fixture());
    EXPECT_TRUE(result.as_expected) << in_words(result);
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
        EXPECT_TRUE(!is_defect(PixelClass(c)) || std::ranges::any_of(all, injects)) << name_of(PixelClass(c));
    }
}

TEST(CatalogueAsAWhole, InjectsWhatItSays) {
    for (const Fault& fault : catalogue()) {
        if (is_control(fault)) continue;
        const Fixture fixture = test_scene_of(fault.fixture_size).fixture();
        const Frame faulty = fault.inject(fixture);
        const bool same_ids = std::ranges::equal(faulty.primitive.pixels(), fixture.good.primitive.pixels());
        const bool same_depths =
            std::ranges::equal(faulty.camera_depth.pixels(), fixture.good.camera_depth.pixels());
        EXPECT_FALSE(same_ids && same_depths && !faulty.attributes.are_given())
            << fault.name << " changes nothing";
    }
}

/// A frame is judged by its own promise: to be like the reference is no excuse.
TEST(EqualToReference, FailsWhereItsRendererPromisesMoreThanTheReferenceKeeps) {
    const Fixture fixture = test_scene_of(FixtureSize::large).fixture();
    const Verdict verdict = judge(fixture.scene, fixture.view, {fixture.reference, fixture.precision},
                                  {fixture.reference, fixture.reference_precision});
    EXPECT_GT(verdict.counts[std::size_t(PixelClass::wrong_depth)], 0u);
    const FramePair pair{fixture.scene,
                         fixture.view,
                         {fixture.view, {fixture.reference, fixture.precision}},
                         {fixture.view, {fixture.reference, fixture.reference_precision}}};
    EXPECT_GT(std::ranges::count(find_unproven_pixels(pair).pixels(), 1), 0)
        << "its ids prove nothing where it promises less";
    EXPECT_EQ(verdict.reference_defects, 0u);
}

}  // namespace
}  // namespace zproof::selftest
