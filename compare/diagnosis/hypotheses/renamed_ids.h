/// Ids under other names.
#pragma once

#include <functional>
#include <span>
#include <unordered_map>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// The id of background.
inline constexpr std::uint32_t nobody = std::uint32_t(PrimitiveId::none);

using Renamed = std::function<std::uint32_t(std::uint32_t id)>;

/// The hypothesis that told(id) is reported instead of an id. Where an id no longer tells which triangle it
/// was, one is sought among those that the reference sees at the pixel and around it. Whether that one is
/// admissible is for the judge to say.
Hypothesis with_ids_reported_as(const DiagnosisInput& input, const Cause& cause, const Renamed& told);

using Ids = std::unordered_map<std::uint32_t, std::uint32_t>;

/// The other id that most pixels have together with each id; the least of equals.
Ids most_often_with(std::span<const PrimitiveId> ids, std::span<const PrimitiveId> others);

/// A curve that pictures put their values through, where what is stored is no colour.
struct ByteCurve {
    const char* name;            ///< after "went through"
    double (*at)(double value);  ///< 0 to 1, of 0 to 1

    /// The cause that `what` (ids, labels) were written as colours.
    Cause cause(const std::string& what) const;
    /// Each of the four bytes through the curve, to whole numbers.
    std::uint32_t operator()(std::uint32_t id) const;
};
/// The curves of sRGB (IEC 61966-2-1) and of a power, there and back.
std::span<const ByteCurve> byte_curves();

/// The part that holds a triangle, as an index; parts stand in triangle order.
std::size_t part_of(const Scene& scene, std::uint32_t triangle);

}  // namespace zproof
