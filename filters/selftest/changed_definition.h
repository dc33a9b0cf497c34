/// Definitions like a claimed one in all but one thing: what a wrong renderer may have computed instead.
#pragma once

#include <optional>

#include "filters/conformance/conformance.h"
#include "filters/selftest/claimed_reference.h"
#include "filters/selftest/filter_fixture.h"

namespace zproof::selftest {

/// What is other than claimed. Empty functions change nothing.
struct DefinitionChange {
    std::string name;                              ///< "half a texel along u"
    std::function<void(Scene&)> of_scene{};        ///< corners and triangles must stay as they are
    std::function<void(FilterClaim&)> of_claim{};  ///< method, options, derivatives, precision
    std::function<void(oracle::FilterSettings&)>
        of_reference{};  ///< what no method of zproof's has a setting for
    std::optional<StepRule> steps{};
    std::function<void(View&)> of_view{};  ///< for the places on textures alone: surfaces stay as they are
    /// The colour that a pixel would have without the change; none where the picture does not tell.
    std::function<std::optional<LinearRgb>(const Picture&, int x, int y)> of_picture{};
};

DefinitionChange moved_place(std::string name, const glm::dvec2& texels);  ///< of level 0
DefinitionChange biased_lod(std::string name, double levels);

FilterClaim claim_under(const DefinitionChange& change, FilterClaim claim);

/// The claimed method's own picture under the change, which must be one of the scene or the claim.
Picture picture_under(const DefinitionChange& change, const FilterFixture& fixture, const FilterClaim& claim);

/// Filter references of one claim under changes. The fixture must outlive it and them; the surfaces that may
/// be seen are found once, and what definitions make of an image is shared.
class ChangedDefinitions {
  public:
    /// The method must have a filter reference.
    ChangedDefinitions(const FilterFixture& fixture, const FilterClaim& claim);

    PixelReference under(const DefinitionChange& change) const;
    PixelReference as_it_is() const { return under({}); }

  private:
    const FilterFixture& fixture_;
    FilterClaim claim_;
    std::shared_ptr<const oracle::AdmissibleSurfaces> surfaces_;
    std::shared_ptr<oracle::filter_reference::SharedImages> images_;
};

}  // namespace zproof::selftest
