#include "filters/selftest/claimed_reference.h"

#include <stdexcept>

namespace zproof::selftest {

const oracle::filter_reference::Definition& definition_of(const std::string& method) {
    const auto* definition = oracle::find_filter_definition(method);
    if (definition == nullptr) throw std::logic_error("no reference for the method '" + method + "'");
    return *definition;
}

namespace {

oracle::filter_reference::ChainKernel chain_kernel(texture::MipKernel kernel) {
    using oracle::filter_reference::ChainKernel;
    switch (kernel) {
        case texture::MipKernel::box:
            return ChainKernel::box;
        case texture::MipKernel::polyphase:
            return ChainKernel::polyphase;
        case texture::MipKernel::lanczos3:
            return ChainKernel::lanczos3;
        case texture::MipKernel::kaiser3:
            return ChainKernel::kaiser3;
    }
    return {};
}

}  // namespace

oracle::FilterSettings reference_settings(const texture::FilterOptions& o, const FilterPrecision& promise) {
    using oracle::filter_reference::Decoding;
    return {.wrap = {},
            .kernel = chain_kernel(o.mip_kernel),
            .lod_bias = o.lod_bias,
            .lod_min = o.lod_min,
            .lod_max = o.lod_max,
            .max_anisotropy = o.max_anisotropy,
            .subdivisions = o.subdivisions,
            .samples = o.samples,
            .seed = o.seed,
            .given_levels = o.given_levels,
            .texel_bits = promise.texel_bits,
            .decoding = o.decoding == texture::Decoding::before_filtering ? Decoding::before_filtering
                                                                          : Decoding::after_filtering};
}

FilterPrecision filter_precision(const texture::FilterOptions& o) {
    const bool is_short = o.sat_storage == texture::SatStorage::float32 ||
                          o.sat_storage == texture::SatStorage::float32_less_mean;
    return {.sum_bits = is_short ? 24.0 : 53.0};
}

StepRule step_rule(texture::Derivatives derivatives) {
    return derivatives == texture::Derivatives::analytic ? StepRule::analytic : StepRule::quad_differences;
}

ClaimedReference::ClaimedReference(const Scene& scene, const View& view, const FilterClaim& claim)
    : definition_(definition_of(claim.method)),
      promise_(claim.precision),
      reference_(scene, view, definition_, reference_settings(claim.options, claim.precision),
                 step_rule(claim.derivatives)),
      surfaces_(scene, view, claim.precision) {}

PermittedColours ClaimedReference::at(int x, int y, const FilterPrecision& precision) const {
    return reference_.at(x, y, surfaces_.at(x, y), precision);
}

std::optional<ColourDraws> ClaimedReference::draws_at(int x, int y) const {
    const auto seen = surfaces_.at(x, y);
    return seen.size() == 1 ? reference_.draws_at(x, y, seen[0], promise_) : std::nullopt;
}

}  // namespace zproof::selftest
