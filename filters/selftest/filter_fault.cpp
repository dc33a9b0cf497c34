#include "filters/selftest/filter_fault.h"

#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>

#include "filters/methods/catalogue.h"
#include "filters/selftest/likely_cause.h"

namespace zproof::selftest {

ConformanceResult conformance_of(const Picture& picture, const FilterFixture& fixture,
                                 const FilterClaim& claim) {
    const ClaimedReference reference{fixture.scene, fixture.view, claim};
    const PixelReference of_pixel = [&](int x, int y, const FilterPrecision& precision) {
        return reference.at(x, y, precision);
    };
    ConformanceResult result{conformance(picture, of_pixel, claim.precision), {}};
    result.rules = rules_at_fault(picture, result.found, of_pixel, claim.precision);
    if (reference.is_stochastic())
        result.chance =
            stochastic_conformance(picture, [&](int x, int y) { return reference.draws_at(x, y); });
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
    const auto rule = rule_told(result.rules);
    text << std::setprecision(3);
    if (rule && rule->rule == FilterRule::factor)
        text << "; at fault: factor, times " << rule->times.r << ", " << rule->times.g << ", "
             << rule->times.b;
    else if (rule)
        text << "; at fault: " << name_of(rule->rule) << ", to " << rule->bits << " bits";
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
        const FilterFixture& fixture = fixture_of(fault.ground);
        const FilterClaim claim{
            .method = fault.method, .options = fault.options, .precision = filter_precision(fault.options)};
        const Picture picture =
            fault.inject(fixture, {.method = *texture::find_method(fault.method), .options = fault.options});
        const ConformanceResult result = conformance_of(picture, fixture, claim);
        const std::vector<std::string> causes = causes_of(picture, ChangedDefinitions{fixture, claim}, claim,
                                                          result.found, likely_changes(fixture.scene, claim));
        tell(result.is_caught() ? "caught" : "MISSED", fault.name,
             in_words(result) + causes_in_words(causes) + " (" + fault.sentence + ")");
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
