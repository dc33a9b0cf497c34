/// Regions against membership of points: what is left by `without` holds exactly the points that it should.
#include "compare/admissible/region.h"

#include <gtest/gtest.h>

#include <deque>

#include "brute_force.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

using Exact = Line<Rational>;

/// A random line through the square of half-side 4; whole numbers, so that corners meet often.
Exact random_line(Rng& rng, int id) {
    Rational a(rng.below(7) - 3), b(rng.below(7) - 3), c(rng.below(13) - 6);
    if (a == 0 && b == 0) a = 1;
    return {{a, b, c}, id, {-1, -1}};
}

class Sheet {
  public:
    Sheet() {
        for (const auto& [a, b] : {std::array{0, 1}, {-1, 0}, {0, -1}, {1, 0}})
            lines_.push_back({{Rational(a), Rational(b), Rational(4)}, -2 - int(lines_.size()), {-1, -1}});
    }
    const Exact* add(Rng& rng) { return &lines_.emplace_back(random_line(rng, -2 - int(lines_.size()))); }
    Region<Rational> square() const {
        return Region<Rational>::square({&lines_[0], &lines_[1], &lines_[2], &lines_[3]}, Rational(4));
    }

  private:
    std::deque<Exact> lines_;
};

brute_force::Functional plain(const Exact& line) { return {line.f.a, line.f.b, line.f.c}; }

brute_force::Set plain_square() { return {{1, 0, 4}, {-1, 0, 4}, {0, 1, 4}, {0, -1, 4}}; }

TEST(Region, InsideIsEmptyExactlyWhereNoPointIsInAllHalfPlanes) {
    int empty = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        Sheet sheet;
        std::optional<Region<Rational>> region = sheet.square();
        brute_force::Set set = plain_square();
        for (int i = 0; i < 4; ++i) {
            const Exact* line = sheet.add(rng);
            if (region) region = region->inside(*line);
            set.push_back(plain(*line));
            ASSERT_EQ(region.has_value(), !brute_force::is_empty(set));
        }
        empty += !region;
    }
    EXPECT_GT(empty, 200);
    EXPECT_LT(empty, 1800);
}

TEST(Region, OutsideIsEmptyExactlyWhereTheClosedHalfPlaneHoldsAllOfTheRegion) {
    int empty = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        Sheet sheet;
        brute_force::Set set = plain_square();
        const Exact *a = sheet.add(rng), *b = sheet.add(rng), *c = sheet.add(rng);
        auto region = sheet.square().inside(*a);
        if (region) region = region->inside(*b);
        if (!region) continue;
        set.push_back(plain(*a));
        set.push_back(plain(*b));
        const bool is_left = region->outside(*c).has_value();
        ASSERT_EQ(is_left, !brute_force::is_covered(set, {{plain(*c)}}));
        ASSERT_EQ(region->untouched_by(*c),
                  is_left && brute_force::is_covered(set, {{plain(Exact{-c->f, 0, {}})}}));
        empty += !is_left;
    }
    EXPECT_GT(empty, 50);
}

TEST(Region, NothingIsLeftExactlyWhereClosedSetsCoverTheSquare) {
    int covered = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        Sheet sheet;
        std::vector<Region<Rational>> left{sheet.square()};
        std::vector<brute_force::Set> sets;
        const Exact* shared = sheet.add(rng);
        const Exact opposite{-shared->f, shared->id, {-1, -1}};
        for (int i = 0; i < 4; ++i) {
            HalfPlanes<Rational> hiding{i % 2 ? shared : &opposite};
            if (rng.below(3)) hiding.push_back(sheet.add(rng));
            sets.emplace_back();
            for (const Exact* line : hiding) sets.back().push_back(plain(*line));
            left = without(left, hiding);
            ASSERT_EQ(left.empty(), brute_force::is_covered(plain_square(), sets));
        }
        covered += left.empty();
    }
    EXPECT_GT(covered, 50);
    EXPECT_LT(covered, 550);
}

/// As edges of a mesh do: many through one point, each with several triangles.
TEST(Region, NothingIsLeftExactlyWhereSetsOfTheSameLinesCoverTheSquare) {
    int covered = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        Sheet sheet;
        std::vector<Exact> lines;  // and their opposites, of the same id
        lines.reserve(14);
        const int x = rng.below(3) - 1, y = rng.below(3) - 1;
        for (int i = 0; i < 7; ++i) {
            Exact line = *sheet.add(rng);
            if (i > 1) line.f.c = -(line.f.a * x + line.f.b * y);
            lines.push_back(line);
            lines.push_back({-line.f, line.id, {-1, -1}});
        }
        std::vector<Region<Rational>> left{sheet.square()};
        std::vector<brute_force::Set> sets;
        for (int i = 0; i < 7; ++i) {
            HalfPlanes<Rational> hiding;
            sets.emplace_back();
            for (int k = rng.below(2); k < 3; ++k) {
                hiding.push_back(&lines[std::size_t(rng.below(int(lines.size())))]);
                sets.back().push_back(plain(*hiding.back()));
            }
            left = without(left, hiding);
            ASSERT_EQ(left.empty(), brute_force::is_covered(plain_square(), sets));
        }
        covered += left.empty();
    }
    EXPECT_GT(covered, 50);
    EXPECT_LT(covered, 1450);
}

TEST(Region, ASquareWithoutSideIsItsCentre) {
    Rng rng(1);
    const Exact side{{1, 0, 0}, -2, {-1, -1}}, through{{1, 1, 0}, -3, {-1, -1}},
        beyond{{1, 1, -1}, -4, {-1, -1}};
    const auto point = Region<Rational>::square({&side, &side, &side, &side}, Rational(0));
    EXPECT_TRUE(point.inside(through));
    EXPECT_FALSE(point.outside(through));
    EXPECT_FALSE(point.inside(beyond));
    EXPECT_TRUE(point.outside(beyond));
}

}  // namespace
}  // namespace zproof
