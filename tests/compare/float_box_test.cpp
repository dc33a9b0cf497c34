/// Boxes in single precision hold those in double, and meet where those do.
#include "compare/search/float_box.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "random_surroundings.h"

namespace zproof {
namespace {

/// With sides on a grid of eighths, so that boxes often touch.
Box random_box(Dice& dice) {
    Box box;
    for (int corner = 0; corner < 2; ++corner) box.add(dice.below(40) / 8.0 - 1, dice.below(40) / 8.0 - 1);
    return box;
}
FloatBox exactly(const Box& box) {
    return {float(box.left), float(box.top), float(box.right), float(box.bottom)};
}

TEST(FloatBox, MeetsWhatItsBoxMeets) {
    Dice dice(1);
    int met = 0, touched = 0;
    for (int round = 0; round < 20000; ++round) {
        const Box a = random_box(dice), b = random_box(dice);
        ASSERT_EQ(exactly(a).meets(exactly(b)), a.meets(b));
        met += a.meets(b);
        touched += a.meets(b) && (a.left == b.right || a.right == b.left);
    }
    EXPECT_GT(met, 1000);
    EXPECT_GT(touched, 100);
    EXPECT_FALSE(FloatBox().meets(FloatBox::everywhere()));
    EXPECT_TRUE(FloatBox::everywhere().meets(exactly({1, 1, 1, 1})));
}

TEST(FloatBox, OfSeveralHoldsEach) {
    Dice dice(2);
    for (int round = 0; round < 1000; ++round) {
        Box all;
        FloatBox found;
        for (int i = 0; i < 3; ++i) {
            const Box one = random_box(dice);
            all.add(one);
            found.add(exactly(one));
        }
        EXPECT_EQ(found.left(), float(all.left));
        EXPECT_EQ(found.top(), float(all.top));
        EXPECT_EQ(found.right(), float(all.right));
        EXPECT_EQ(found.bottom(), float(all.bottom));
    }
}

TEST(FloatBox, IsRoundedOutwards) {
    Dice dice(3);
    for (int round = 0; round < 1000; ++round) {
        const auto place = [&] { return dice.between(-40000, 40000); };
        Box box;
        box.add(place(), place());
        box.add(place(), place());
        const Box found = FloatBox::holding(box).in_double();
        EXPECT_LT(found.left, box.left);
        EXPECT_LT(found.top, box.top);
        EXPECT_GT(found.right, box.right);
        EXPECT_GT(found.bottom, box.bottom);
        Box wider = box;
        wider.widen(1.0 / 64);
        EXPECT_TRUE(wider.left < found.left && found.right < wider.right);
    }
}

TEST(FloatBox, HoldsWhatNoFloatHolds) {
    constexpr double last = std::numeric_limits<float>::max(), far = 1e39,
                     infinite = std::numeric_limits<double>::infinity();
    const std::array places{-infinite, -far, -last, -1.0, -1e-45, 0.0, 1e-45, 1.0, last, far, infinite};
    for (const double left : places)
        for (const double right : places) {
            if (left > right || left == infinite || right == -infinite) continue;
            const Box box{left, 0, right, 1};
            const FloatBox found = FloatBox::holding(box);
            EXPECT_TRUE(found.left() <= left || found.left() == float(last)) << left;
            EXPECT_TRUE(found.right() >= right || found.right() == float(-last)) << right;
            for (const double other : places) {
                if (other < left || right < other || std::abs(other) == infinite) continue;
                EXPECT_TRUE(found.meets(FloatBox::holding({other, 0, other, 1}))) << left << ' ' << right;
            }
        }
}

TEST(FloatBox, FitsWhatIsAsLongAsItsLongerSide) {
    const FloatBox box(1, 2, 4, 9);
    EXPECT_TRUE(box.fits(7));
    EXPECT_FALSE(box.fits(6.5F));
    EXPECT_FALSE(FloatBox::everywhere().fits(std::numeric_limits<float>::max()));
    EXPECT_TRUE(FloatBox::everywhere().is_everywhere());
    EXPECT_FALSE(box.is_everywhere());
}

TEST(FloatBox, CellsAreHeldWithinTheImage) {
    const FloatBox::Places last{99, 49, 99, 49};
    const auto cells = [&](const FloatBox& box) {
        const FloatBox::Places found = box.cells(4, last);
        return std::array{found[0], found[1], found[2], found[3]};
    };
    EXPECT_EQ(cells({3, 4, 8, 15.5F}), (std::array{0, 1, 2, 3}));
    EXPECT_EQ(cells({-7, 12, 1e30F, 300}), (std::array{0, 3, 99, 49}));
    EXPECT_EQ(cells(FloatBox::everywhere()), (std::array{0, 0, 99, 49}));
}

}  // namespace
}  // namespace zproof
