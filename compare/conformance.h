/// Does a filtered picture keep to its definition? Each pixel is held against the colours that the filter
/// reference permits there; what fails is put to the filter reference again with one declared precision
/// relaxed at a time, and a rule that alone explains it is named (docs/filter-conformance.md).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frame/colour_range.h"
#include "frame/filter_precision.h"
#include "frame/picture.h"

namespace zproof {

/// The filter reference, asked about one pixel.
using PixelReference = std::function<PermittedColours(int x, int y, const FilterPrecision&)>;

/// The part of a definition that a wrong pixel points at.
enum class FilterRule {
    coordinates,  ///< where on the texture
    footprint,    ///< how far the texture runs on per pixel
    lod,          ///< which level
    weights,      ///< how texels and levels are weighted
    taps,         ///< where the reads of one lookup stand
    sums,         ///< how texels are stored and added up, or anything else: it bounds any error
    other,        ///< none of these, relaxed alone, explains it
};
/// "coordinates", "LOD", ...
std::string name_of(FilterRule rule);

/// The least relaxation of one rule that explains all wrong pixels asked about, or the widest tried.
struct RuleRelaxation {
    FilterRule rule = FilterRule::other;
    double bits = 0;        ///< to which the rule would have to hold; below 0: errors of several units
    double explained = 0;   ///< share of the wrong pixels asked about
    double permissive = 0;  ///< mean width of what is permitted then: the cost of the explanation
};

struct FilterPixel {
    int x = 0, y = 0;
    auto operator<=>(const FilterPixel&) const = default;
};

/// The box of pixels that hold what is outside.
struct ExtentOutside {
    FilterPixel first, last;
};

struct Conformance {
    std::uint64_t judged = 0;    ///< all pixels
    std::uint64_t outside = 0;   ///< those that no range permits
    std::uint64_t anything = 0;  ///< those where the filter reference permits everything
    double worst_slack =
        0;                  ///< factor by which the widest-missing range would have to be widened; <= 1: none
    double mean_width = 0;  ///< of what is permitted, averaged over channels; how sharp the question was
    FilterPixel worst;
    std::optional<ExtentOutside> where;  ///< none where nothing is outside
    Plane<float> slack;                  ///< per pixel, for a picture
};

/// The permitted range that has to be widened least to hold the colour, the first of equals.
const ColourRange& nearest_range(const LinearRgb& colour, const PermittedColours& permitted);

/// How far the nearest permitted range would have to be widened about its middle to hold the colour: |v -
/// middle| / half-width, the largest over the channels. Infinite where the colour is not finite.
double slack_of(const LinearRgb& colour, const PermittedColours& permitted);

/// Runs on the threads of the surrounding tbb::task_arena; all of them ask the filter reference.
Conformance conformance(const Picture& picture, const PixelReference& reference,
                        const FilterPrecision& precision);

/// Every rule that explains something, the cheapest explanation first; of up to 400 wrong pixels, evenly
/// taken.
std::vector<RuleRelaxation> rules_at_fault(const Picture& picture, const Conformance& found,
                                           const PixelReference& reference, const FilterPrecision& precision);

/// The rule that explains every wrong pixel asked about, where no other one does however far it gives way;
/// nothing where several do. Texels and sums, which bound any error, count only where no other rule does.
/// Weights are not told where nothing less than any mean of what is read explains the pixels.
std::optional<RuleRelaxation> rule_told(const std::vector<RuleRelaxation>& rules);

}  // namespace zproof
