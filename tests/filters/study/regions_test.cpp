#include "filters/study/regions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace zproof::study {
namespace {

using oracle::TruthKind;

const Region& named(const std::vector<Region>& all, const std::string& name) {
    return *std::ranges::find(all, name, &Region::name);
}

/// A row of pixels, one patch and kind each; those of a truth that is sampled lie in one surface.
struct Row {
    std::vector<std::pair<Patch, TruthKind>> pixels;

    std::vector<Region> regions() const {
        const Resolution size{int(pixels.size()), 1};
        Plane<Patch> patches(size);
        Plane<TruthKind> around(size), truth(size);
        for (int x = 0; x < size.width; ++x) {
            patches.at(x, 0) = pixels[std::size_t(x)].first;
            truth.at(x, 0) = around.at(x, 0) = pixels[std::size_t(x)].second;
            if (truth.at(x, 0) == TruthKind::sampled) around.at(x, 0) = TruthKind::interior;
        }
        return study::regions(patches, around, truth);
    }
};

Patch patch(double major, double minor, double angle = 0) { return {major, minor, angle, 512}; }

TEST(Regions, StandInTheOrderOfTheirCards) {
    const std::vector<Region> all = Row{{{patch(2, 1), TruthKind::interior}}}.regions();
    const std::vector<RegionCard> cards = region_cards();
    ASSERT_EQ(all.size(), cards.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].name, cards[i].name);
}

TEST(Regions, SortPixelsByWhatTheTruthSees) {
    const std::vector<Region> all = Row{{{patch(2, 1), TruthKind::interior},
                                         {patch(2, 1), TruthKind::silhouette},
                                         {patch(2, 1), TruthKind::sampled},
                                         {{}, TruthKind::background},
                                         {{}, TruthKind::interior}}}  // without a texture
                                        .regions();
    EXPECT_EQ(named(all, "all").pixels, 5u);
    EXPECT_EQ(named(all, "interior").pixels, 2u);
    EXPECT_EQ(named(all, "silhouette").pixels, 1u);
    EXPECT_EQ(named(all, "sampled").pixels, 1u);
    EXPECT_EQ(named(all, "interior").mask.at(0, 0), 1);
    EXPECT_EQ(named(all, "interior").mask.at(2, 0), 1);
    EXPECT_EQ(named(all, "interior").mask.at(4, 0), 0);
}

TEST(Regions, MagnifiedAndHorizonByTheAxes) {
    const std::vector<Region> all = Row{
        {{patch(3, 0.99), TruthKind::interior},
         {patch(3, 1), TruthKind::interior},
         {patch(512, 40), TruthKind::interior},
         {patch(512.5, 40),
          TruthKind::sampled}}}.regions();
    EXPECT_EQ(named(all, "magnified").pixels, 1u);
    EXPECT_EQ(named(all, "horizon").pixels, 1u);
    EXPECT_EQ(named(all, "horizon").mask.at(3, 0), 1);
}

/// Every interior pixel has exactly one class of anisotropy, and from 2 on one angle.
TEST(Regions, ClassesAndAnglesAreAPartition) {
    Row row;
    for (const double ratio : {1.0, 1.09, 1.0905, 1.99, 2.0, 3.99, 4.0, 8.0, 16.0, 31.0, 32.0, 1e9})
        for (const double angle : {0.0, 7.49, 7.5, 44.0, 89.999, 90.0})
            row.pixels.push_back({patch(ratio, 1, angle), TruthKind::interior});
    const std::vector<Region> all = row.regions();
    for (int x = 0; x < int(row.pixels.size()); ++x) {
        int classes = 0, angles = 0;
        for (const Region& region : all) {
            classes += region.name.starts_with("anisotropy") ? region.mask.at(x, 0) : 0;
            angles += region.name.starts_with("angle") ? region.mask.at(x, 0) : 0;
        }
        EXPECT_EQ(classes, 1) << x;
        EXPECT_EQ(angles, row.pixels[std::size_t(x)].first.major >= 2 ? 1 : 0) << x;
    }
    EXPECT_EQ(named(all, "anisotropy 1").pixels, 12u);
    EXPECT_EQ(named(all, "anisotropy 2-4").pixels, 12u);
    EXPECT_EQ(named(all, "anisotropy 32+").pixels, 12u);
    EXPECT_EQ(named(all, "angle 82.5-90").pixels, 16u);
}

}  // namespace
}  // namespace zproof::study
