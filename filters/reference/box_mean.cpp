#include "filters/reference/box_mean.h"

namespace zproof::oracle::filter_reference {

namespace {

constexpr double multiple = 0x1p-35;

/// Sum up to a place on a wrapped axis as a combination of the sums up to whole texels.
struct AxisTerm {
    int texels = 0;
    double weight = 0;
};
using AxisTerms = std::vector<AxisTerm>;

/// Up to a place within [0, size]: between two whole sums, since texels are constant.
void add_within(AxisTerms& terms, double place, int size, double weight) {
    const int whole = std::min(int(std::floor(place)), size - 1);
    const double share = place - whole;
    terms.push_back({whole, weight * (1 - share)});
    terms.push_back({whole + 1, weight * share});
}

void add_clamped(AxisTerms& terms, double place, int size, double weight) {
    add_within(terms, std::clamp(place, 0.0, double(size)), size, weight);
    if (place < 0) terms.push_back({1, weight * place});
    if (place > size) {
        terms.push_back({size, weight * (place - size)});
        terms.push_back({size - 1, -weight * (place - size)});
    }
}

void add_periodic(AxisTerms& terms, Wrap wrap, double place, int size, double weight) {
    const int images = wrap == Wrap::mirrored_repeat ? 2 : 1, period = images * size;
    const double periods = std::floor(place / period), within = place - periods * period;
    terms.push_back({size, weight * periods * images});
    if (within <= size) return add_within(terms, within, size, weight);
    // Mirrored: all of the image, less what is not yet covered of the way back.
    terms.push_back({size, 2 * weight});
    add_within(terms, period - within, size, -weight);
}

/// The terms of the mean from low to high.
AxisTerms terms_as_they_are(Wrap wrap, double low, double high, int size) {
    AxisTerms terms;
    if (wrap == Wrap::clamp_to_edge) {
        add_clamped(terms, high, size, 1);
        add_clamped(terms, low, size, -1);
    } else {
        add_periodic(terms, wrap, high, size, 1);
        add_periodic(terms, wrap, low, size, -1);
    }
    return terms;
}

/// Both places are shifted by whole periods so that low lies in the first one: nothing large cancels.
AxisTerms axis_terms(Wrap wrap, double low, double high, int size) {
    if (wrap == Wrap::clamp_to_edge) return terms_as_they_are(wrap, low, high, size);
    const double period = wrap == Wrap::mirrored_repeat ? 2.0 * size : size,
                 shift = std::floor(low / period) * period;
    return terms_as_they_are(wrap, low - shift, high - shift, size);
}

/// What an implementation adds up that shifts no places.
double sum_of_weights(Wrap wrap, const Interval& low, const Interval& high, int size) {
    double sum = 0;
    for (const AxisTerm& term : terms_as_they_are(wrap, middle(low), middle(high), size))
        sum += std::abs(term.weight);
    return sum;
}

}  // namespace

BoxMean::BoxMean(const texture::LinearImage& image, const WrapRules& wrap, const glm::ivec2& more_texels)
    : width_(image.width),
      height_(image.height),
      wrap_(wrap),
      more_texels_(more_texels),
      sums_(std::size_t(image.width + 1) * std::size_t(image.height + 1), Sum{0}) {
    for (int row = 0; row < height_; ++row) {
        Sum line{0};
        for (int column = 0; column < width_; ++column) {
            const glm::dvec3 texel{glm::vec3{image.at(column, row)}}, scaled = glm::round(texel / multiple);
            least_ = glm::min(least_, texel), most_ = glm::max(most_, texel);
            quantized_ = glm::max(quantized_, glm::abs(texel - scaled * multiple));
            line += Sum{scaled};
            sums_[std::size_t(row + 1) * std::size_t(width_ + 1) + std::size_t(column + 1)] =
                sum(column + 1, row) + line;
        }
    }
}

/// Moving an edge by r changes the mean by at most r spread / width: the mean of the strip it gains less the
/// box's own.
ColourRange BoxMean::over(const Box& stated, const FilterPrecision& precision) const {
    const double error = std::exp2(-precision.place_bits);
    const Box box{widen(stated.left, error), widen(stated.right, error), widen(stated.top, error),
                  widen(stated.bottom, error)};
    const double left = middle(box.left), right = middle(box.right), top = middle(box.top),
                 bottom = middle(box.bottom);
    const double area = (right - left) * (bottom - top);
    const AxisTerms across = axis_terms(wrap_.u, left, right + more_texels_.x, width_),
                    down = axis_terms(wrap_.v, top, bottom + more_texels_.y, height_);
    glm::dvec3 total{0};
    for (const AxisTerm& v : down)
        for (const AxisTerm& u : across) total += u.weight * v.weight * glm::dvec3{sum(u.texels, v.texels)};
    const double size = sum_of_weights(wrap_.u, box.left, box.right, width_) *
                        sum_of_weights(wrap_.v, box.top, box.bottom, height_);
    const double thin_u = box.right.low() - box.left.high(), thin_v = box.bottom.low() - box.top.high();
    const double moved = (radius(box.left) + radius(box.right)) / std::max(thin_u, 0x1p-40) +
                         (radius(box.top) + radius(box.bottom)) / std::max(thin_v, 0x1p-40);
    // Stored sums are at most the whole image's; each is rounded once, and our own way here has 24 roundings.
    const glm::dvec3 whole = glm::dvec3{sum(width_, height_)} * multiple;
    const double unit = std::exp2(-precision.sum_bits) + 24 * 0x1p-53;
    const glm::dvec3 stored = unit * (size + 4) * 4.0 * whole / area;
    // Whatever the box, its mean lies among the texels; one that is too long for its area has none.
    const ColourRange mean = around(total * multiple / area, moved * (most_ - least_) + stored + quantized_);
    if (more_texels_ != glm::dvec2{0}) return mean;
    return {glm::max(mean.low, least_ - stored), glm::min(mean.high, most_ + stored)};
}

}  // namespace zproof::oracle::filter_reference
