/// A filter fault: one way in which a filtered picture can be wrong, and the test that must find it.
#pragma once

#include "filters/conformance/rule_at_fault.h"
#include "filters/conformance/stochastic_conformance.h"
#include "filters/selftest/claimed_reference.h"
#include "filters/selftest/filter_fixture.h"
#include "program/selftest_score.h"

namespace zproof::selftest {

using texture::Footprint;

/// The method, told another footprint than the pixel's; `size` is the texture's, texels.
using Distortion = std::function<Footprint(Footprint, const glm::dvec2& size)>;
texture::Method distorted(const texture::Method& method, const Distortion& distortion);

struct FilterFault {
    std::string name;      ///< letters, digits and '_'
    std::string sentence;  ///< what is wrong, for people
    std::string method;    ///< by whose filter reference the picture is judged
    std::function<Picture(const FilterFixture&, const rasterizer::Texturing& right)> inject;
    texture::FilterOptions options{};
    Ground ground = Ground::noise;
};

/// Every filter fault, in the order in which they are told: places, levels, weights, taps, draws, textures.
std::vector<FilterFault> filter_faults();

struct ConformanceResult {
    Conformance found;
    std::vector<RuleRelaxation> rules;              ///< the likeliest first
    std::optional<StochasticConformance> chance{};  ///< of a stochastic method

    bool is_caught() const { return found.outside > 0 || (chance && chance->is_outside()); }
};

/// What the filter reference of a method says of a picture of a fixture. The method must have a filter
/// reference.
ConformanceResult conformance_of(const Picture& picture, const FilterFixture& fixture,
                                 const FilterClaim& claim);

/// Judges the picture by what zproof's own filters promise.
ConformanceResult conformance_of(const Picture& picture, const FilterFixture& fixture,
                                 const std::string& method, const texture::FilterOptions& options,
                                 texture::Derivatives derivatives = texture::Derivatives::analytic);

/// Injects the fault into the fixture and asks the filter reference.
ConformanceResult try_filter_fault(const FilterFault& fault, const FilterFixture& fixture);

/// "7310 of 11520 pixels outside, slack 1.2e+06; at fault: LOD, to 0 bits", "...; rule at fault: not told"
std::string in_words(const ConformanceResult& result);

/// "mean, red: 2.1 standard deviations off over 9240 pixels, at most 7.8 by chance"
std::string in_words(const StochasticConformance& chance);

/// Tries each method of the catalogue as a control, and every filter fault, and tells a line of each.
Score try_filters(const ProgressSink& progress_sink);

/// How many tests that are.
int filter_test_count();

}  // namespace zproof::selftest
