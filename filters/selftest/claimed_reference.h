/// What a picture claims to be, and what the filter reference of that method permits it to show.
#pragma once

#include <optional>
#include <string>

#include "filters/reference/admissible_surfaces.h"
#include "filters/reference/filter_reference.h"
#include "rasterizer/texturing.h"

namespace zproof::selftest {

/// The options of a method under a promise, as its filter reference knows them.
oracle::FilterSettings reference_settings(const texture::FilterOptions& options,
                                          const FilterPrecision& promise);
/// What the options promise.
FilterPrecision filter_precision(const texture::FilterOptions& options);
StepRule step_rule(texture::Derivatives derivatives);

/// The filter reference of a method. Throws std::logic_error where it has none.
const oracle::filter_reference::Definition& definition_of(const std::string& method);

/// What a picture claims to be.
struct FilterClaim {
    std::string method;
    texture::FilterOptions options{};
    texture::Derivatives derivatives = texture::Derivatives::analytic;
    FilterPrecision precision{};
};

/// A claim on one view of a scene, over all surfaces that its promise admits. Scene and view must outlive it.
/// May be asked from many threads.
class ClaimedReference {
  public:
    /// Throws std::logic_error where the method has no filter reference.
    ClaimedReference(const Scene& scene, const View& view, const FilterClaim& claim);

    PermittedColours at(int x, int y, const FilterPrecision& precision) const;

    bool is_stochastic() const { return bool(definition_.draws); }
    /// What a sample may be where the promise admits one surface alone; else none.
    std::optional<ColourDraws> draws_at(int x, int y) const;

  private:
    const oracle::filter_reference::Definition& definition_;
    FilterPrecision promise_;
    oracle::FilterReference reference_;
    oracle::AdmissibleSurfaces surfaces_;
};

}  // namespace zproof::selftest
