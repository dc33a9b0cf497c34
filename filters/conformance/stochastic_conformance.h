/// Has a picture of a stochastic filter the mean and the variance that its definition says? Sums over the
/// picture are held against what chance alone would make of them (docs/filter-conformance.md).
///
/// The draws of all pixels are independent of each other: white noise.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "filters/conformance/filter_precision.h"
#include "filters/reference/permitted_colours.h"
#include "frame/picture.h"

namespace zproof {

/// The filter reference, asked what a pixel may draw. None: the pixel says nothing.
using DrawQuery = std::function<std::optional<ColourDraws>(int x, int y)>;

/// The probability that any test of a right picture fails is at most this. All else follows from it by
/// Bernstein's inequality.
inline constexpr double false_alarm_rate = 1e-9;

/// A sum over the picture, in standard deviations from its expectation.
struct StochasticTest {
    std::string name;  ///< "mean, red"
    double z = 0;      ///< beyond what the declared precision permits the expectation to be off
    double limit = 0;  ///< |z| of a right picture exceeds it with a bounded probability

    bool is_outside() const { return !(std::abs(z) <= limit); }
};

struct StochasticConformance {
    std::uint64_t pixels = 0;  ///< that took part
    std::vector<StochasticTest> tests;

    bool is_outside() const;
    /// The test that lies farthest from its expectation, in limits. There is one where pixels took part.
    const StochasticTest& worst() const;
};

/// Runs on the threads of the surrounding tbb::task_arena; the result does not depend on their number.
StochasticConformance stochastic_conformance(const Picture& picture, const DrawQuery& draws_at);

}  // namespace zproof
