#include "filters/conformance/joint_conformance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "filters/conformance/joint_fit.h"
#include "filters/conformance/sign_probability.h"

namespace zproof {

namespace {

/// For each value that depends on the offset: the least offset that the promise does not admit there.
std::vector<double> thresholds(const Response& response) {
    std::vector<double> all;
    for (std::size_t i = 0; i < response.change.size(); ++i)
        if (response.change[i] != 0) all.push_back(response.admitted[i] / std::abs(response.change[i]));
    std::ranges::sort(all);
    return all;
}

/// One test: values count by how far an offset of `size` would move them beyond what the promise admits, so
/// that those on which the promise is sharp decide.
struct Excess {
    double log2_chance = 0;
    double promised = 0;  ///< the offset that the promise admits on the average of what counts
};

Excess excess_beyond(const Samples& samples, const Response& response, double offset, const Values& residual,
                     const Resolution& size) {
    const double sign = offset < 0 ? -1 : 1;
    Blocks sums{size};
    double moved = 0, allowed = 0;
    for (std::size_t i = 0; i < residual.size(); ++i) {
        const double change = std::abs(response.change[i]), most = response.admitted[i];
        const double counts = samples.weight[i] * std::max(std::abs(offset) * change - most, 0.0);
        if (!(counts > 0)) continue;
        const double along = sign * (response.change[i] > 0 ? residual[i] : -residual[i]);
        sums.add(samples.pixels[i / 3], counts * (along - most));
        moved += counts * change, allowed += counts * most;
    }
    return {std::max(log2_chance(sums.rows), log2_chance(sums.columns)), moved > 0 ? allowed / moved : 0};
}

/// Tested are all values, the half of them that the promise moves least per unit of the offset, a quarter,
/// and so on.
constexpr int tests_of_a_sign = 8;

/// The test with the least chance; where none exceeds the promise, that of a quarter of the values.
Excess worst_excess(const Samples& samples, const Response& response, double sign, const Values& residual,
                    const Resolution& size) {
    const std::vector<double> least = thresholds(response);
    const auto test = [&](int halvings) {
        return excess_beyond(samples, response, sign * least[(least.size() - 1) >> halvings], residual, size);
    };
    Excess worst = test(2);
    for (int halvings = 0; halvings < tests_of_a_sign; ++halvings)
        if (const Excess excess = test(halvings); excess.log2_chance < worst.log2_chance) worst = excess;
    return worst;
}

/// How values answer to an offset: of a large one, from the definition to that offset (the secant), else next
/// to the definition.
Response response_to(const Samples& samples, const OffsetFit& fit, std::size_t k) {
    Response response = samples.responses[k];
    if (!fit.has_converged || std::abs(fit.offsets[k]) <= joint_step) return response;
    for (std::size_t i = 0; i < response.change.size(); ++i)
        response.change[i] = (fit.residual_without[k][i] - fit.residual[i]) / fit.offsets[k];
    return response;
}

OffsetEstimate estimate(const Samples& samples, const OffsetFit& fit, std::size_t k, const Resolution& size) {
    OffsetEstimate found{.name = {}, .unit = {}};
    if (!samples.responses[k].is_told()) return found;
    found.is_told = true;
    found.value = fit.offsets[k];
    found.standard_error = fit.standard_errors[k];
    // Others are taken away as they were estimated.
    const Excess excess = worst_excess(samples, response_to(samples, fit, k), found.value < 0 ? -1 : 1,
                                       fit.residual_without[k], size);
    found.promised = excess.promised;
    found.log2_chance = excess.log2_chance;
    return found;
}

/// A row counts for the alternative where the picture is nearer to it there than to the definition:
///     sum w d (r - d / 2) > 0    with d the alternative's difference and r the picture's
AlternativeFit fit_alternative(const Samples& samples, const Values& residual, std::size_t a,
                               const Resolution& size) {
    AlternativeFit found{.name = {}};
    std::vector<const Values*> changes;
    for (const Response& response : samples.responses) changes.push_back(&response.change);
    const Values difference = without(samples.weight, samples.alternatives[a], changes);
    const double all = weighted_dot(samples.weight, samples.alternatives[a], samples.alternatives[a]),
                 length2 = weighted_dot(samples.weight, difference, difference);
    if (!is_left(length2, all)) return found;
    found.is_told = true;
    found.share = weighted_dot(samples.weight, difference, residual) / length2;
    Blocks nearer{size}, errors{size};
    for (std::size_t i = 0; i < residual.size(); ++i) {
        const double counts = samples.weight[i] * difference[i];
        nearer.add(samples.pixels[i / 3], counts * (residual[i] - difference[i] / 2));
        errors.add(samples.pixels[i / 3], counts * (residual[i] - found.share * difference[i]) / length2);
    }
    found.standard_error = standard_error(errors);
    found.log2_chance = std::max(log2_chance(nearer.rows), log2_chance(nearer.columns));
    return found;
}

/// The share of the pixels that the definition with these offsets permits.
double explained_share(const Picture& picture, const Samples& samples, const PixelReference& shifted,
                       const FilterPrecision& promise) {
    std::vector<char> is_inside(samples.pixels.size());
    tbb::parallel_for(std::size_t{0}, is_inside.size(), [&](std::size_t i) {
        const FilterPixel& p = samples.pixels[i];
        is_inside[i] = slack_of(picture.at(p.x, p.y), shifted(p.x, p.y, promise)) <= 1;
    });
    return is_inside.empty() ? 0 : double(std::ranges::count(is_inside, char{1})) / double(is_inside.size());
}

}  // namespace

bool JointConformance::leaves_promise() const {
    return std::ranges::any_of(offsets, &OffsetEstimate::leaves_promise) ||
           std::ranges::any_of(alternatives, &AlternativeFit::is_nearer);
}

JointCheck::JointCheck(const Resolution& size, JointReferences references, const FilterPrecision& promise)
    : references_(std::move(references)),
      promise_(promise),
      samples_(std::make_shared<const Samples>(samples_of(size, references_, promise))) {
    // Either sign of every offset has so many tests, every alternative one; the rate is shared among them
    // (Bonferroni).
    const double tests =
        2.0 * tests_of_a_sign * double(references_.offsets.size()) + double(references_.alternatives.size());
    log2_least_chance_ = log2_false_alarm - std::log2(std::max(tests, 1.0));
}

JointConformance JointCheck::judge(const Picture& picture) const {
    const OffsetFit fit = fit_offsets(picture, *samples_, references_);
    JointConformance found{.offsets = {}, .alternatives = {}, .pixels = samples_->pixels.size()};
    found.has_converged = fit.has_converged;
    found.log2_least_chance = log2_least_chance_;
    for (std::size_t k = 0; k < references_.offsets.size(); ++k) {
        OffsetEstimate offset = estimate(*samples_, fit, k, picture.size());
        offset.name = references_.offsets[k].name, offset.unit = references_.offsets[k].unit;
        offset.leaves_promise = offset.log2_chance <= log2_least_chance_;
        found.offsets.push_back(std::move(offset));
    }
    for (std::size_t a = 0; a < references_.alternatives.size(); ++a) {
        AlternativeFit other = fit_alternative(*samples_, fit.residual, a, picture.size());
        other.name = references_.alternatives[a].name;
        other.is_nearer = other.log2_chance <= log2_least_chance_;
        found.alternatives.push_back(std::move(other));
    }
    const std::vector<double> nothing(fit.offsets.size(), 0);
    for (const std::vector<double>& offsets : {nothing, fit.offsets})
        found.explained = std::max(
            found.explained, explained_share(picture, *samples_, references_.shifted(offsets), promise_));
    return found;
}

}  // namespace zproof
