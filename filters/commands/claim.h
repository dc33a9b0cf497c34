/// The method that a picture claims to be of, as typed, and what that method permits it to show.
#pragma once

#include <optional>
#include <string>

#include "filters/commands/filter_choice.h"
#include "filters/conformance/permitted_interval.h"
#include "filters/selftest/claimed_reference.h"

namespace zproof {

struct PictureClaim {
    FilterChoice method;
    std::string promise;  ///< as typed; empty: what zproof's own filters promise
    selftest::FilterClaim claim;
};

/// A method under a promise; none: under that of zproof's own filters. Throws UsageError where the method has
/// no filter reference.
selftest::FilterClaim claim_of(const FilterChoice& choice, const std::optional<FilterPrecision>& promise);

/// What it permits at one pixel of a picture that has this colour there.
PermittedFloats permitted_at(const selftest::FilterClaim& claim, const FilterPixel& pixel,
                             const LinearRgb& colour, const Scene& scene, const View& view);

/// Runs on the threads of the surrounding tbb::task_arena.
PermittedInterval permitted_by(const selftest::FilterClaim& claim, const Picture& picture, const Scene& scene,
                               const View& view);

}  // namespace zproof
