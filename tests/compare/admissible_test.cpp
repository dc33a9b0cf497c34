/// The admissible set beside the brute-force one: not one disagreement, in exact numbers or in intervals.
#include "compare/admissible/admissible_set.h"

#include <gtest/gtest.h>

#include <functional>

#include "brute_force.h"
#include "compare/admissible/admissibility.h"
#include "compare/admissible/coplanar.h"
#include "math/interval.h"
#include "math/lazy_rational.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr std::uint32_t seeds = 120;
constexpr std::uint32_t far_corner = 1346;  ///< a corner at 1e10: its plane in double is off by 50 times
constexpr std::array all_rules{Rules{DepthRule::strict, EdgeRule::watertight},
                               Rules{DepthRule::bounded, EdgeRule::watertight},
                               Rules{DepthRule::bounded, EdgeRule::separate}};

/// Answers of one admissible set, in the order in which `questions_for` asks.
using Question = std::function<bool()>;

template <class Set>
std::vector<Question> questions_for(Set& set, std::size_t count, const std::vector<bool>& is_edge_on) {
    std::vector<Question> questions;
    for (const EdgeRule rule : {EdgeRule::watertight, EdgeRule::separate})
        questions.emplace_back([&set, rule] { return set.holds_background(rule); });
    for (std::size_t i = 0; i < count; ++i) {
        if (is_edge_on[i]) continue;
        questions.emplace_back([&set, i] { return set.reaches(i); });
        questions.emplace_back([&set, i] { return set.is_visible(i); });
        for (const Rules rules : all_rules)
            questions.emplace_back([&set, i, rules] { return set.holds(i, rules); });
    }
    return questions;
}

std::vector<bool> edge_on(const Neighbourhood& around) {
    std::vector<bool> flags;
    for (const Neighbour& n : around.neighbours)
        flags.push_back(
            !image_of(ViewRay<Rational>(around.view, around.x, around.y), corners<Rational>(n.p_world)));
    return flags;
}

std::optional<bool> answer_or_undecided(const Question& question) {
    try {
        return question();
    } catch (const UndecidedSign&) {
        return std::nullopt;
    }
}

TEST(AdmissibleSet, AgreesWithBruteForceOnRandomAndHardSurroundings) {
    int asked = 0, decided = 0, yes = 0;
    for (std::uint32_t seed = 0; seed <= seeds; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed < seeds ? seed : far_corner);
        const std::size_t count = s.around.neighbours.size();
        const std::vector<bool> flags = edge_on(s.around);
        const brute_force::Picture plain(s.around);
        AdmissibleSet<Rational> exact(s.around);
        AdmissibleSet<LazyRational> lazy(s.around);
        AdmissibleSet<Interval> fast(s.around);
        const auto expected = questions_for(plain, count, flags),
                   of_exact = questions_for(exact, count, flags), of_lazy = questions_for(lazy, count, flags),
                   of_fast = questions_for(fast, count, flags);
        for (std::size_t q = 0; q < expected.size(); ++q) {
            const bool truth = expected[q]();
            ASSERT_EQ(of_exact[q](), truth) << "question " << q;
            ASSERT_EQ(of_lazy[q](), truth) << "question " << q;
            const std::optional<bool> claimed = answer_or_undecided(of_fast[q]);
            ASSERT_EQ(claimed.value_or(truth), truth) << "question " << q;
            ++asked, decided += claimed.has_value(), yes += truth;
        }
    }
    EXPECT_GT(decided, asked / 2) << "intervals decide most questions";
    EXPECT_GT(yes, asked / 10);
    EXPECT_LT(yes, 9 * asked / 10);
}

/// Two edges of a triangle whose directions have the same quotient of slope_of(): they are two lines.
TEST(AdmissibleSet, KeepsEdgesOfOneSlopeApart) {
    constexpr double eps_px = 1.0 / 512;
    const View view = pixel_view(Projection::parallel, 4, 4);
    const ViewBounds bounds(view, raster_precision());
    int seen = 0;
    for (int offset = -24; offset <= 24; ++offset) {
        SCOPED_TRACE(offset);
        const double x = 1.5 + offset % 7 * eps_px / 2, y = 1.5 + offset / 7 * eps_px / 2;
        const Triangle one{{{x, y, 8}, {x - 1.5, y - 5, 8}, {x + 3.5, y, 3}}};
        const Triangle below{{{x - 3.5, y, 13}, {x + 3.5, y, 3}, {x, 12, 8}}};
        const Scene scene = scene_of(view, {one, below, wall(20)});
        const auto corner = [&](std::size_t i) { return scene.vertices.position_world[i]; };
        ASSERT_FALSE(are_turned(slope_of(corner(0), corner(1)), slope_of(corner(0), corner(2))));
        const Neighbourhood around = surroundings(scene, view, bounds, {1, 1}, 0);
        const brute_force::Picture plain(around);
        AdmissibleSet<Rational> exact(around);
        EXPECT_EQ(exact.is_visible(2), plain.is_visible(2));
        seen += plain.is_visible(2);
    }
    EXPECT_GT(seen, 10);
    EXPECT_LT(seen, 49);
}

}  // namespace
}  // namespace zproof
