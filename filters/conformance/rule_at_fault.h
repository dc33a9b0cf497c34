/// Which rule of its definition does a wrong picture break? What fails is put to the filter reference again
/// with one declared precision relaxed at a time, or held to one factor (docs/filter-conformance.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/conformance/conformance.h"

namespace zproof {

/// The part of a definition that a wrong pixel points at.
enum class FilterRule {
    coordinates,  ///< where on the texture
    footprint,    ///< how far the texture runs on per pixel
    lod,          ///< which level
    weights,      ///< how texels and levels are weighted
    taps,         ///< where the reads of one lookup stand
    factor,       ///< the material's: all values are so many times what they should be
    sums,         ///< how texels are stored and added up, or anything else: it bounds any error
    other,        ///< none of these, relaxed alone, explains it
};
/// "coordinates", "LOD", ...
std::string name_of(FilterRule rule);

/// The least relaxation of one rule that explains all wrong pixels asked about, or the widest tried.
struct RuleRelaxation {
    FilterRule rule = FilterRule::other;
    double bits = 0;                 ///< to which the rule would have to hold; below 0: several units
    double explained = 0;            ///< share of the wrong pixels asked about
    double explained_reflected = 0;  ///< the same of errors of the other sign
    bool is_everywhere = true;       ///< Does it explain the pixels that were not asked about, too?
    double permissive = 0;           ///< mean width of what is permitted then: the cost of the explanation
    glm::dvec3 times{1};             ///< of FilterRule::factor, which has no bits: by channel
};

/// Every rule that explains something, the cheapest explanation first; of up to 400 wrong pixels, evenly
/// taken. What explains all of these is held to the whole picture.
std::vector<RuleRelaxation> rules_at_fault(const Picture& picture, const Conformance& found,
                                           const PixelReference& reference, const FilterPrecision& precision);

/// A factor that explains the whole picture. Else the rule that explains it, where no other one does however
/// far it gives way, and at a lower cost than any error of that size; nothing where several do, or where
/// places would have to move and could make the opposite errors as well. Texels and sums, which bound any
/// error, count only where no other rule does. Weights are not told where nothing less than any mean of what
/// is read explains the pixels.
std::optional<RuleRelaxation> rule_told(const std::vector<RuleRelaxation>& rules);

}  // namespace zproof
