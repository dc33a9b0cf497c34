#include "measure/fit/octaves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace zproof::measure {
namespace {

/// With so many octaves between two, what lies in one is more than factor_apart times what lies in the other.
constexpr int octaves_of_a_gap = 4;
static_assert(1 << octaves_of_a_gap > factor_apart);
constexpr std::uint64_t pixels_per_lone_one = 1000;

}  // namespace

int octave_of(double value) {
    if (!(value > std::ldexp(1.0, least_octave))) return least_octave;
    if (value > std::ldexp(1.0, most_octave)) return no_octave;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);  // in [1/2, 1)
    return mantissa == 0.5 ? exponent - 1 : exponent;
}

std::uint64_t OctaveCounts::all() const {
    return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

std::uint64_t OctaveCounts::above(int octave) const {
    return std::accumulate(counts_.begin() + std::ptrdiff_t(index(octave)) + 1, counts_.end(),
                           std::uint64_t{0});
}

int OctaveCounts::greatest() const {
    int octave = no_octave;
    while (octave > least_octave && at(octave) == 0) --octave;
    return octave;
}

std::optional<int> OctaveCounts::last_before_gap() const {
    const std::uint64_t err = above(least_octave) - at(no_octave), most_alone = all() / pixels_per_lone_one;
    std::optional<int> last;
    int widest = octaves_of_a_gap - 1, before = least_octave;
    for (int octave = least_octave + 1; octave <= most_octave; ++octave) {
        if (at(octave) == 0) continue;
        const int gap = octave - before - 1;
        const std::uint64_t alone = above(before) - at(no_octave);
        if (before > least_octave && gap > widest && alone <= most_alone && 2 * alone < err) {
            widest = gap;
            last = before;
        }
        before = octave;
    }
    return last;
}

}  // namespace zproof::measure
