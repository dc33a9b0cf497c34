#include "filters/conformance/joint_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zproof {

namespace {

/// One pixel's share of the samples.
struct PixelAnswer {
    ColourRange exact, promised;
    std::vector<ColourRange> below, above, own;
    std::vector<std::optional<ColourRange>> alternatives;
};

glm::dvec3 middle_of(const ColourRange& range) { return range.low + (range.high - range.low) / 2.0; }

/// The pixels to ask about: all of a small picture, else every n-th along each row, one on in the next row,
/// so that every row and every column keeps its share.
std::vector<FilterPixel> pixels_to_ask(const Resolution& size) {
    constexpr std::uint64_t most = 16384;
    const int n = int((size.pixel_count() + most - 1) / most);
    std::vector<FilterPixel> pixels;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if ((x + y) % n == 0) pixels.push_back({x, y});
    return pixels;
}

/// The references that every pixel is asked of.
struct Question {
    const JointReferences& references;
    const FilterPrecision& promise;
    PixelReference definition;
    std::vector<PixelReference> below, above;

    Question(const JointReferences& r, const FilterPrecision& p) : references(r), promise(p) {
        std::vector<double> offsets(r.offsets.size(), 0);
        definition = r.shifted(offsets);
        for (std::size_t k = 0; k < offsets.size(); ++k) {
            offsets[k] = -joint_step, below.push_back(r.shifted(offsets));
            offsets[k] = joint_step, above.push_back(r.shifted(offsets));
            offsets[k] = 0;
        }
    }
};

std::optional<PixelAnswer> answer(const Question& q, const FilterPixel& p) {
    const auto exact = only_range(q.definition, p, {}), promised = only_range(q.definition, p, q.promise);
    if (!exact || !promised) return {};
    PixelAnswer found{*exact, *promised, {}, {}, {}, {}};
    for (std::size_t k = 0; k < q.below.size(); ++k) {
        const auto below = only_range(q.below[k], p, {}), above = only_range(q.above[k], p, {}),
                   own = only_range(q.definition, p, q.references.offsets[k].own);
        if (!below || !above || !own) return {};
        found.below.push_back(*below), found.above.push_back(*above), found.own.push_back(*own);
    }
    for (const AlternativeReference& alternative : q.references.alternatives)
        found.alternatives.push_back(only_range(alternative.reference, p, {}));
    return found;
}

void add(Samples& samples, const FilterPixel& p, const PixelAnswer& found) {
    samples.pixels.push_back(p);
    const glm::dvec3 exact = middle_of(found.exact);
    for (int c = 0; c < 3; ++c) {
        const double half = (found.promised.high[c] - found.promised.low[c]) / 2;
        samples.exact.push_back(exact[c]);
        samples.weight.push_back(half > 0 ? 1 / (half * half) : 0);
        for (std::size_t k = 0; k < found.own.size(); ++k) {
            Response& response = samples.responses[k];
            response.change.push_back((middle_of(found.above[k])[c] - middle_of(found.below[k])[c]) /
                                      (2 * joint_step));
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

void find_unique(Samples& samples, std::size_t k) {
    Response& response = samples.responses[k];
    std::vector<const Values*> others;
    for (std::size_t j = 0; j < samples.responses.size(); ++j)
        if (j != k) others.push_back(&samples.responses[j].change);
    response.unique = without(samples.weight, response.change, others);
    const double all = weighted_dot(samples.weight, response.change, response.change),
                 rest = weighted_dot(samples.weight, response.unique, response.unique);
    response.unique_share = all > 0 ? rest / all : 0;
}

/// a less its projection on b.
void remove(const Values& weight, Values& a, const Values& b) {
    const double length2 = weighted_dot(weight, b, b);
    if (!(length2 > 0)) return;
    const double share = weighted_dot(weight, a, b) / length2;
    for (std::size_t i = 0; i < a.size(); ++i) a[i] -= share * b[i];
}

}  // namespace

bool Response::is_told() const { return is_left(unique_share, 1); }

double weighted_dot(const Values& weight, const Values& a, const Values& b) {
    double sum = 0;
    for (std::size_t i = 0; i < weight.size(); ++i) sum += weight[i] * a[i] * b[i];
    return sum;
}

Values without(const Values& weight, Values values, std::span<const Values* const> changes) {
    std::vector<Values> others;
    for (const Values* const change : changes) {
        Values other = *change;
        for (const Values& earlier : others) remove(weight, other, earlier);
        others.push_back(std::move(other));
    }
    for (const Values& other : others) remove(weight, values, other);
    return values;
}

std::optional<ColourRange> only_range(const PixelReference& reference, const FilterPixel& p,
                                      const FilterPrecision& precision) {
    const PermittedColours permitted = reference(p.x, p.y, precision);
    if (permitted.size() != 1) return {};
    const glm::dvec3 width = permitted[0].high - permitted[0].low;
    if (!std::isfinite(width.x + width.y + width.z)) return {};
    return permitted[0];
}

std::vector<std::optional<glm::dvec3>> values_of(const PixelReference& definition,
                                                 std::span<const FilterPixel> pixels) {
    std::vector<std::optional<glm::dvec3>> values(pixels.size());
    tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t i) {
        if (const auto range = only_range(definition, pixels[i], {})) values[i] = middle_of(*range);
    });
    return values;
}

Samples samples_of(const Resolution& size, const JointReferences& references,
                   const FilterPrecision& promise) {
    const Question question{references, promise};
    const std::vector<FilterPixel> pixels = pixels_to_ask(size);
    std::vector<std::optional<PixelAnswer>> answers(pixels.size());
    tbb::parallel_for(std::size_t{0}, pixels.size(),
                      [&](std::size_t i) { answers[i] = answer(question, pixels[i]); });
    Samples samples;
    samples.responses.resize(references.offsets.size());
    samples.alternatives.resize(references.alternatives.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (answers[i]) add(samples, pixels[i], *answers[i]);
    for (std::size_t k = 0; k < samples.responses.size(); ++k) find_unique(samples, k);
    return samples;
}

Values shown_by(const Picture& picture, const Samples& samples) {
    Values values;
    for (std::size_t i = 0; i < samples.pixels.size(); ++i) {
        const LinearRgb& colour = picture.at(samples.pixels[i].x, samples.pixels[i].y);
        const std::array<double, 3> of_channel{colour.r, colour.g, colour.b};
        for (std::size_t c = 0; c < 3; ++c)
            values.push_back(std::isfinite(of_channel[c]) ? of_channel[c] : samples.exact[3 * i + c]);
    }
    return values;
}

}  // namespace zproof
