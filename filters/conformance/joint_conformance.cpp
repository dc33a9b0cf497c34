#include "filters/conformance/joint_conformance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "filters/conformance/sign_probability.h"

namespace zproof {

namespace {

/// One value per channel of every pixel told apart.
using Values = std::vector<double>;

/// The least share of a square that rounding did not make: at least half of a double's digits are left of it.
constexpr double least_unique = 0x1p-26;

/// How a picture answers to one offset.
struct Response {
    Values change;            ///< of the value per unit of the offset
    Values admitted;          ///< how far the promise of this offset alone moves the value
    Values unique;            ///< the change that no other offset can imitate: orthogonal to theirs
    double unique_share = 0;  ///< of the change's square

    bool is_told() const { return unique_share > least_unique; }
};

/// What is asked of the references, pixel after pixel.
struct Samples {
    std::vector<FilterPixel> pixels;
    Values residual;  ///< shown less what the exact definition shows
    Values weight;    ///< 1 / (half-width of what the promise permits)^2
    std::vector<Response> responses;
    std::vector<Values> alternatives;  ///< what each shows less what the definition shows; 0 where undecided
};

/// One pixel's share of the samples; nothing where a decision is undecided.
struct PixelAnswer {
    ColourRange exact, promised;
    std::vector<ColourRange> below, above, own;
    std::vector<std::optional<ColourRange>> alternatives;
};

std::optional<ColourRange> only_range(const PixelReference& reference, const FilterPixel& p,
                                      const FilterPrecision& precision) {
    const PermittedColours permitted = reference(p.x, p.y, precision);
    if (permitted.size() != 1) return {};
    const glm::dvec3 width = permitted[0].high - permitted[0].low;
    if (!std::isfinite(width.x + width.y + width.z)) return {};
    return permitted[0];
}

glm::dvec3 middle_of(const ColourRange& range) { return range.low + (range.high - range.low) / 2.0; }

/// The pixels to ask about: all of a small picture, else every n-th along each row, one on in the next row,
/// so that every row and every column keeps its share.
std::vector<FilterPixel> some_pixels(const Resolution& size) {
    constexpr std::uint64_t most = 16384;
    const int n = int((size.pixel_count() + most - 1) / most);
    std::vector<FilterPixel> pixels;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if ((x + y) % n == 0) pixels.push_back({x, y});
    return pixels;
}

struct Question {
    const Picture& picture;
    const JointReferences& references;
    const FilterPrecision& promise;
};

std::optional<PixelAnswer> answer(const Question& q, const FilterPixel& p) {
    const LinearRgb& shown = q.picture.at(p.x, p.y);
    if (!std::isfinite(shown.r + shown.g + shown.b)) return {};
    const auto exact = only_range(q.references.definition, p, {}),
               promised = only_range(q.references.definition, p, q.promise);
    if (!exact || !promised) return {};
    PixelAnswer found{*exact, *promised, {}, {}, {}, {}};
    for (const OffsetReference& offset : q.references.offsets) {
        const auto below = only_range(offset.below, p, {}), above = only_range(offset.above, p, {}),
                   own = only_range(q.references.definition, p, offset.own);
        if (!below || !above || !own) return {};
        found.below.push_back(*below), found.above.push_back(*above), found.own.push_back(*own);
    }
    for (const AlternativeReference& alternative : q.references.alternatives)
        found.alternatives.push_back(only_range(alternative.reference, p, {}));
    return found;
}

void add(Samples& samples, const Question& q, const FilterPixel& p, const PixelAnswer& found) {
    const LinearRgb& shown = q.picture.at(p.x, p.y);
    const std::array<double, 3> value{shown.r, shown.g, shown.b};
    samples.pixels.push_back(p);
    const glm::dvec3 exact = middle_of(found.exact);
    for (int c = 0; c < 3; ++c) {
        const double half = (found.promised.high[c] - found.promised.low[c]) / 2;
        samples.residual.push_back(value[std::size_t(c)] - exact[c]);
        samples.weight.push_back(half > 0 ? 1 / (half * half) : 0);
        for (std::size_t k = 0; k < q.references.offsets.size(); ++k) {
            Response& response = samples.responses[k];
            const double change = (middle_of(found.above[k])[c] - middle_of(found.below[k])[c]) / 2;
            response.change.push_back(change / q.references.offsets[k].step);
            // To either side: next to a bend (a texel's centre, a whole level) one side alone says too
            // little.
            response.admitted.push_back(
                std::max(found.own[k].high[c] - exact[c], exact[c] - found.own[k].low[c]));
        }
        for (std::size_t a = 0; a < found.alternatives.size(); ++a) {
            const auto& shown_by_it = found.alternatives[a];
            samples.alternatives[a].push_back(shown_by_it ? middle_of(*shown_by_it)[c] - exact[c] : 0);
        }
    }
}

Samples samples_of(const Question& q) {
    const std::vector<FilterPixel> pixels = some_pixels(q.picture.size());
    std::vector<std::optional<PixelAnswer>> answers(pixels.size());
    tbb::parallel_for(std::size_t{0}, pixels.size(),
                      [&](std::size_t i) { answers[i] = answer(q, pixels[i]); });
    Samples samples;
    samples.responses.resize(q.references.offsets.size());
    samples.alternatives.resize(q.references.alternatives.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (answers[i]) add(samples, q, pixels[i], *answers[i]);
    return samples;
}

double weighted_dot(const Values& weight, const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < weight.size(); ++i) sum += weight[i] * a[i] * b[i];
    return sum;
}

/// a less its projection on b.
void remove(const Values& weight, Values& a, const Values& b) {
    const double length2 = weighted_dot(weight, b, b);
    if (!(length2 > 0)) return;
    const double share = weighted_dot(weight, a, b) / length2;
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= share * b[i];
}

/// What is left of values when the changes of all offsets but `except` were removed (Gram and Schmidt;
/// Frisch, Waugh and Lovell: what it tells of a picture is what the joint fit tells).
Values without_offsets(const Samples& samples, Values values, std::optional<std::size_t> except) {
    std::vector<Values> others;
    for (std::size_t j = 0; j < samples.responses.size(); ++j) {
        if (j == except) continue;
        Values other = samples.responses[j].change;
        for (const Values& earlier : others) remove(samples.weight, other, earlier);
        others.push_back(std::move(other));
    }
    for (const Values& other : others) remove(samples.weight, values, other);
    return values;
}

void find_unique(Samples& samples, std::size_t k) {
    Response& response = samples.responses[k];
    response.unique = without_offsets(samples, response.change, k);
    const double all = weighted_dot(samples.weight, response.change, response.change),
                 rest = weighted_dot(samples.weight, response.unique, response.unique);
    response.unique_share = all > 0 ? rest / all : 0;
}

/// Sums over rows, then over columns, of pixels.
struct Blocks {
    std::vector<double> rows, columns;

    explicit Blocks(const Resolution& size)
        : rows(std::size_t(size.height)), columns(std::size_t(size.width)) {}
    void add(const FilterPixel& p, double value) {
        rows[std::size_t(p.y)] += value, columns[std::size_t(p.x)] += value;
    }
};

/// The larger of both sums' standard errors (cluster-robust: pixels of a block may err together).
double standard_error(const Blocks& errors) {
    const auto root = [](const std::vector<double>& sums) {
        return std::sqrt(std::inner_product(sums.begin(), sums.end(), sums.begin(), 0.0));
    };
    return std::max(root(errors.rows), root(errors.columns));
}

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

Excess excess_beyond(const Samples& samples, std::size_t k, double offset, const Values& residual,
                     const Resolution& size) {
    const Response& response = samples.responses[k];
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
Excess worst_excess(const Samples& samples, std::size_t k, double sign, const Values& residual,
                    const Resolution& size) {
    const std::vector<double> least = thresholds(samples.responses[k]);
    const auto test = [&](int halvings) {
        return excess_beyond(samples, k, sign * least[(least.size() - 1) >> halvings], residual, size);
    };
    Excess worst = test(2);
    for (int halvings = 0; halvings < tests_of_a_sign; ++halvings)
        if (const Excess excess = test(halvings); excess.log2_chance < worst.log2_chance) worst = excess;
    return worst;
}

OffsetEstimate estimate(const Samples& samples, const std::vector<double>& offsets, std::size_t k,
                        const Resolution& size) {
    const Response& response = samples.responses[k];
    OffsetEstimate found{.name = {}, .unit = {}};
    if (!response.is_told()) return found;
    found.is_told = true;
    found.value = offsets[k];
    // Others are taken away as they were estimated.
    Values residual = samples.residual;
    for (std::size_t j = 0; j < offsets.size(); ++j)
        for (std::size_t i = 0; j != k && i < residual.size(); ++i)
            residual[i] -= offsets[j] * samples.responses[j].change[i];
    Blocks errors{size};
    const double length2 = weighted_dot(samples.weight, response.unique, response.unique);
    for (std::size_t i = 0; i < residual.size(); ++i)
        errors.add(samples.pixels[i / 3], samples.weight[i] * response.unique[i] *
                                              (residual[i] - found.value * response.change[i]) / length2);
    found.standard_error = standard_error(errors);
    const Excess excess = worst_excess(samples, k, found.value < 0 ? -1 : 1, residual, size);
    found.promised = excess.promised;
    found.log2_chance = excess.log2_chance;
    return found;
}

/// The picture's difference from the definition, less what offsets explain.
Values unexplained(const Samples& samples, const std::vector<double>& offsets) {
    Values residual = samples.residual;
    for (std::size_t k = 0; k < offsets.size(); ++k)
        for (std::size_t i = 0; i < residual.size(); ++i)
            residual[i] -= offsets[k] * samples.responses[k].change[i];
    return residual;
}

/// A row counts for the alternative where the picture is nearer to it there than to the definition:
///     sum w d (r - d / 2) > 0    with d the alternative's difference and r the picture's
AlternativeFit fit(const Samples& samples, const std::vector<double>& offsets, std::size_t a,
                   const Resolution& size) {
    AlternativeFit found{.name = {}};
    const Values difference = without_offsets(samples, samples.alternatives[a], {}),
                 residual = unexplained(samples, offsets);
    const double all = weighted_dot(samples.weight, samples.alternatives[a], samples.alternatives[a]),
                 length2 = weighted_dot(samples.weight, difference, difference);
    if (!(length2 > least_unique * all)) return found;
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

}  // namespace

bool JointConformance::leaves_promise() const {
    return std::ranges::any_of(offsets, &OffsetEstimate::leaves_promise) ||
           std::ranges::any_of(alternatives, &AlternativeFit::is_nearer);
}

JointConformance joint_conformance(const Picture& picture, const JointReferences& references,
                                   const FilterPrecision& promise) {
    Samples samples = samples_of({picture, references, promise});
    std::vector<double> values;
    for (std::size_t k = 0; k < samples.responses.size(); ++k) {
        find_unique(samples, k);
        const Response& response = samples.responses[k];
        const double length2 = weighted_dot(samples.weight, response.unique, response.unique);
        values.push_back(response.is_told()
                             ? weighted_dot(samples.weight, response.unique, samples.residual) / length2
                             : 0);
    }
    // Either sign of every offset has so many tests, every alternative one; the rate is shared among them
    // (Bonferroni).
    const double tests =
        2.0 * tests_of_a_sign * double(references.offsets.size()) + double(references.alternatives.size());
    const double least = log2_false_alarm - std::log2(std::max(tests, 1.0));
    JointConformance found{.offsets = {}, .alternatives = {}, .pixels = samples.pixels.size()};
    for (std::size_t k = 0; k < references.offsets.size(); ++k) {
        OffsetEstimate offset = estimate(samples, values, k, picture.size());
        offset.name = references.offsets[k].name, offset.unit = references.offsets[k].unit;
        offset.leaves_promise = offset.log2_chance <= least;
        found.offsets.push_back(std::move(offset));
    }
    for (std::size_t a = 0; a < references.alternatives.size(); ++a) {
        AlternativeFit other = fit(samples, values, a, picture.size());
        other.name = references.alternatives[a].name;
        other.is_nearer = other.log2_chance <= least;
        found.alternatives.push_back(std::move(other));
    }
    return found;
}

}  // namespace zproof
