#include "cli/selftest/filter_fault.h"

#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>

#include "oracle/admissible_surfaces.h"
#include "texture/catalogue.h"

namespace zproof::selftest {

oracle::FilterSettings reference_settings(const texture::FilterOptions& o) {
    using oracle::filter_reference::ChainKernel;
    const auto kernel = o.mip_kernel == texture::MipKernel::box         ? ChainKernel::box
                        : o.mip_kernel == texture::MipKernel::polyphase ? ChainKernel::polyphase
                                                                        : ChainKernel::lanczos3;
    return {.wrap = {},
            .kernel = kernel,
            .lod_bias = o.lod_bias,
            .lod_min = o.lod_min,
            .lod_max = o.lod_max,
            .max_anisotropy = o.max_anisotropy,
            .subdivisions = o.subdivisions,
            .samples = o.samples,
            .seed = o.seed,
            .given_levels = o.given_levels};
}

FilterPrecision filter_precision(const texture::FilterOptions& o) {
    const bool is_short = o.sat_storage == texture::SatStorage::float32 ||
                          o.sat_storage == texture::SatStorage::float32_less_mean;
    return {.sum_bits = is_short ? 24.0 : 53.0};
}

StepRule step_rule(texture::Derivatives derivatives) {
    return derivatives == texture::Derivatives::analytic ? StepRule::analytic : StepRule::quad_differences;
}

ConformanceResult conformance_of(const Picture& picture, const FilterFixture& fixture,
                                 const FilterClaim& claim) {
    const auto* definition = oracle::find_filter_definition(claim.method);
    if (definition == nullptr) throw std::logic_error("no reference for the method '" + claim.method + "'");
    const oracle::FilterReference reference{fixture.scene, fixture.view, *definition,
                                            reference_settings(claim.options), step_rule(claim.derivatives)};
    const oracle::AdmissibleSurfaces surfaces{fixture.scene, fixture.view, claim.precision};
    const PixelReference of_pixel = [&](int x, int y, const FilterPrecision& precision) {
        return reference.at(x, y, surfaces.at(x, y), precision);
    };
    ConformanceResult result{conformance(picture, of_pixel, claim.precision), {}};
    result.rules = rules_at_fault(picture, result.found, of_pixel, claim.precision);
    if (definition->draws)
        result.chance = stochastic_conformance(picture, [&](int x, int y) {
            const auto seen = surfaces.at(x, y);
            return seen.size() == 1 ? reference.draws_at(x, y, seen[0], claim.precision) : std::nullopt;
        });
    return result;
}

ConformanceResult conformance_of(const Picture& picture, const FilterFixture& fixture,
                                 const std::string& method, const texture::FilterOptions& options,
                                 texture::Derivatives derivatives) {
    return conformance_of(picture, fixture, {method, options, derivatives, filter_precision(options)});
}

ConformanceResult try_filter_fault(const FilterFault& fault, const FilterFixture& fixture) {
    const texture::Method* method = texture::find_method(fault.method);
    if (method == nullptr) throw std::logic_error("no method '" + fault.method + "'");
    const Picture picture = fault.inject(fixture, {.method = *method, .options = fault.options});
    return conformance_of(picture, fixture, fault.method, fault.options);
}

std::string in_words(const StochasticConformance& chance) {
    if (chance.pixels == 0) return "no pixel to test by chance";
    const StochasticTest& worst = chance.worst();
    std::ostringstream text;
    text << worst.name << ": " << std::setprecision(2) << worst.z << " standard deviations off over "
         << chance.pixels << " pixels, at most " << worst.limit << " by chance";
    return text.str();
}

std::string in_words(const ConformanceResult& result) {
    const std::string chance = result.chance ? in_words(*result.chance) : "";
    if (result.found.outside == 0) return "no pixel outside" + (chance.empty() ? chance : "; " + chance);
    std::ostringstream text;
    text << result.found.outside << " of " << result.found.judged << " pixels outside, slack "
         << std::setprecision(2) << result.found.worst_slack;
    if (const auto rule = rule_told(result.rules))
        text << "; at fault: " << name_of(rule->rule) << ", to " << std::setprecision(3) << rule->bits
             << " bits";
    else
        text << "; rule at fault: not told";
    return text.str();
}

namespace {

/// Runs tests one by one, on fixtures that are made when first needed.
class Round {
  public:
    explicit Round(const ProgressSink& progress_sink) : progress_sink_(progress_sink) {}

    void control(const texture::Method& method) {
        if (!begins("filter " + method.name)) return;
        const FilterFixture& fixture = fixture_of(Ground::noise);
        const Picture picture =
            rasterizer::filtered(fixture.scene, fixture.view, fixture.frame, {.method = method});
        const ConformanceResult result = conformance_of(picture, fixture, method.name, {});
        tell(result.is_caught() ? "FAILED" : "passed", "filter " + method.name, in_words(result));
        ++score_.controls;
        score_.passed += !result.is_caught();
    }

    void fault(const FilterFault& fault) {
        if (!begins(fault.name)) return;
        const ConformanceResult result = try_filter_fault(fault, fixture_of(fault.ground));
        tell(result.is_caught() ? "caught" : "MISSED", fault.name,
             in_words(result) + " (" + fault.sentence + ")");
        ++score_.faults;
        score_.caught += result.is_caught();
    }

    const Score& score() const { return score_; }

  private:
    bool begins(const std::string& name) {
        if (progress_sink_.wants_to_stop()) return false;
        progress_sink_.begins(name);
        return true;
    }

    void tell(const char* mark, const std::string& name, const std::string& words) {
        std::ostringstream line;
        line << mark << "  " << std::left << std::setw(32) << name << words << "\n";
        progress_sink_.told(line.str());
    }

    const FilterFixture& fixture_of(Ground ground) {
        const auto found = stages_.find(ground);
        return found != stages_.end() ? found->second
                                      : stages_.emplace(ground, filter_fixture(ground)).first->second;
    }

    const ProgressSink& progress_sink_;
    std::map<Ground, FilterFixture> stages_;
    Score score_;
};

}  // namespace

int filter_test_count() { return int(texture::methods().size() + filter_faults().size()); }

Score try_filters(const ProgressSink& progress_sink) {
    Round round{progress_sink};
    for (const texture::Method& method : texture::methods()) round.control(method);
    for (const FilterFault& fault : filter_faults()) round.fault(fault);
    return round.score();
}

}  // namespace zproof::selftest
