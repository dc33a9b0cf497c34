#include "cli/selftest/filter_fault.h"

#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>

#include "texture/catalogue.h"

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

FilterPrecision filter_precision(const texture::FilterOptions& o) {
    const bool is_short = o.sat_storage == texture::SatStorage::float32 ||
                          o.sat_storage == texture::SatStorage::float32_less_mean;
    return {.sum_bits = is_short ? 24.0 : 53.0};
}

StepRule step_rule(texture::Derivatives derivatives) {
    return derivatives == texture::Derivatives::analytic ? StepRule::analytic : StepRule::quad_differences;
}

FilterTrial conformance_of(const Picture& picture, const FilterStage& stage, const FilterClaim& claim) {
    const auto* definition = oracle::find_filter_definition(claim.method);
    if (definition == nullptr) throw std::logic_error("no law for the method '" + claim.method + "'");
    const oracle::FilterLaw law{stage.scene, stage.view, *definition, law_settings(claim.options),
                                step_rule(claim.derivatives)};
    const PixelLaw of_pixel = [&](int x, int y, const FilterPrecision& precision) {
        return law.at(x, y, stage.frame.primitive.at(x, y), precision);
    };
    FilterTrial trial{conformance(picture, of_pixel, claim.precision), {}};
    trial.rules = rules_at_fault(picture, trial.found, of_pixel, claim.precision);
    return trial;
}

FilterTrial conformance_of(const Picture& picture, const FilterStage& stage, const std::string& method,
                           const texture::FilterOptions& options, texture::Derivatives derivatives) {
    return conformance_of(picture, stage, {method, options, derivatives, filter_precision(options)});
}

FilterTrial try_filter_fault(const FilterFault& fault, const FilterStage& stage) {
    const texture::Method* method = texture::find_method(fault.method);
    if (method == nullptr) throw std::logic_error("no method '" + fault.method + "'");
    const Picture picture = fault.inject(stage, {.method = *method, .options = fault.options});
    return conformance_of(picture, stage, fault.method, fault.options);
}

std::string in_words(const FilterTrial& trial) {
    if (!trial.is_caught()) return "no pixel outside";
    std::ostringstream text;
    text << trial.found.outside << " of " << trial.found.judged << " pixels outside, slack "
         << std::setprecision(2) << trial.found.worst_slack;
    if (!trial.rules.empty() && trial.rules.front().explained >= 0.99)
        text << "; likeliest: " << name_of(trial.rules.front().rule) << ", to " << std::setprecision(3)
             << trial.rules.front().bits << " bits";
    else
        text << "; no rule alone explains it";
    return text.str();
}

namespace {

/// Runs trials one by one, on stages that are made when first needed.
class Round {
  public:
    explicit Round(const Audience& audience) : audience_(audience) {}

    void control(const texture::Method& method) {
        if (!begins("filter " + method.name)) return;
        const FilterStage& stage = stage_of(Ground::noise);
        const Picture picture =
            rasterizer::filtered(stage.scene, stage.view, stage.frame, {.method = method});
        const FilterTrial trial = conformance_of(picture, stage, method.name, {});
        tell(trial.is_caught() ? "FAILED" : "passed", "filter " + method.name, in_words(trial));
        ++score_.controls;
        score_.passed += !trial.is_caught();
    }

    void fault(const FilterFault& fault) {
        if (!begins(fault.name)) return;
        const FilterTrial trial = try_filter_fault(fault, stage_of(fault.ground));
        tell(trial.is_caught() ? "caught" : "MISSED", fault.name,
             in_words(trial) + " (" + fault.sentence + ")");
        ++score_.faults;
        score_.caught += trial.is_caught();
    }

    const Score& score() const { return score_; }

  private:
    bool begins(const std::string& name) {
        if (audience_.wants_to_stop()) return false;
        audience_.begins(name);
        return true;
    }

    void tell(const char* mark, const std::string& name, const std::string& words) {
        std::ostringstream line;
        line << mark << "  " << std::left << std::setw(32) << name << words << "\n";
        audience_.told(line.str());
    }

    const FilterStage& stage_of(Ground ground) {
        const auto found = stages_.find(ground);
        return found != stages_.end() ? found->second
                                      : stages_.emplace(ground, filter_stage(ground)).first->second;
    }

    const Audience& audience_;
    std::map<Ground, FilterStage> stages_;
    Score score_;
};

}  // namespace

int filter_trial_count() { return int(texture::methods().size() + filter_faults().size()); }

Score try_filters(const Audience& audience) {
    Round round{audience};
    for (const texture::Method& method : texture::methods()) round.control(method);
    for (const FilterFault& fault : filter_faults()) round.fault(fault);
    return round.score();
}

}  // namespace zproof::selftest
