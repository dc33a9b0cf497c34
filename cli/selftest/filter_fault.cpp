#include "cli/selftest/filter_fault.h"

#include <stdexcept>

namespace zproof::selftest {

oracle::FilterSettings law_settings(const texture::FilterOptions& o) {
    using oracle::filter_law::ChainKernel;
    const auto kernel = o.mip_kernel == texture::MipKernel::box         ? ChainKernel::box
                        : o.mip_kernel == texture::MipKernel::polyphase ? ChainKernel::polyphase
                                                                        : ChainKernel::lanczos3;
    return {.wrap = {},
            .kernel = kernel,
            .lod_bias = o.lod_bias,
            .lod_min = o.lod_min,
            .lod_max = o.lod_max,
            .max_anisotropy = o.max_anisotropy,
            .subdivisions = o.subdivisions};
}

StepRule step_rule(texture::Derivatives derivatives) {
    return derivatives == texture::Derivatives::analytic ? StepRule::analytic : StepRule::quad_differences;
}

Conformance conformance_of(const Picture& picture, const FilterStage& stage, const std::string& method,
                           const texture::FilterOptions& options, texture::Derivatives derivatives) {
    const auto* definition = oracle::find_filter_definition(method);
    if (definition == nullptr) throw std::logic_error("no law for the method '" + method + "'");
    const oracle::FilterLaw law{stage.scene, stage.view, *definition, law_settings(options),
                                step_rule(derivatives)};
    const PixelLaw of_pixel = [&](int x, int y, const FilterPrecision& precision) {
        return law.at(x, y, stage.frame.primitive.at(x, y), precision);
    };
    return conformance(picture, of_pixel, FilterPrecision{});
}

}  // namespace zproof::selftest
