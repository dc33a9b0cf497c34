#include "filters/reference/interval_image.h"

#include <algorithm>
#include <optional>

namespace zproof::oracle::filter_reference {

namespace {

/// A place is read at most this many texels wide; wider ones, which only a search for a cause asks for, know
/// no more than the whole image's range.
constexpr double widest_read = 8;

/// The interval's ends and the multiples of 1 / parts between them.
std::vector<double> cuts_of(const Interval& a, double parts) {
    std::vector<double> cuts{a.low()};
    for (double n = std::floor(a.low() * parts) + 1; n / parts < a.high(); ++n) cuts.push_back(n / parts);
    cuts.push_back(a.high());
    return cuts;
}

/// A texel beside the centre `at`, of the period of that centre where reads end at seams.
int read_index(const WrapRules& rules, Wrap wrap, std::int64_t texel, double at, int size) {
    if (rules.ends_at_seams && wrap == Wrap::repeat) {
        const auto first = std::int64_t(std::floor((at + 0.5) / size)) * size;
        texel = std::clamp(texel, first, first + size - 1);
    }
    return wrapped_index(wrap, texel, size);
}

bool is_too_wide(const TexelInterval& p) {
    return !(p.u.high() - p.u.low() < widest_read && p.v.high() - p.v.low() < widest_read);
}

/// The four texels around a place whose centres are at whole numbers.
struct Cell {
    std::array<IntervalImage::Texel, 4> texels;

    /// `inside`: a centre within it, which tells the period where reads end at seams.
    Cell(const IntervalImage& image, const WrapRules& wrap, std::int64_t left, std::int64_t top,
         const glm::dvec2& inside) {
        for (int k = 0; k < 4; ++k)
            texels[std::size_t(k)] = image.at(read_index(wrap, wrap.u, left + k % 2, inside.x, image.width),
                                              read_index(wrap, wrap.v, top + k / 2, inside.y, image.height));
    }
    ColourRange at(double x, double y) const {
        glm::dvec3 value{0}, radius{0};
        for (int k = 0; k < 4; ++k) {
            const double w = (k % 2 == 1 ? x : 1 - x) * (k / 2 == 1 ? y : 1 - y);
            value += w * texels[std::size_t(k)].value;
            radius += w * texels[std::size_t(k)].radius;
        }
        return around(value, radius);
    }
    /// What it costs that the weights of either axis are off by e: at most e times this, for each axis.
    glm::dvec3 spread() const {
        glm::dvec3 low = texels[0].value, high = low;
        for (const auto& t : texels) low = glm::min(low, t.value), high = glm::max(high, t.value);
        return high - low;
    }
    /// What a split between the columns moves from one to the other, and within each column.
    glm::dvec3 cost_of_splits(double y) const {
        const auto apart = [&](int from, int to, double share) {
            const auto &a = texels[std::size_t(from)], &b = texels[std::size_t(to)];
            return IntervalImage::Texel{share * (b.value - a.value), share * (a.radius + b.radius)};
        };
        const auto upper = apart(0, 1, 1 - y), lower = apart(2, 3, y), left = apart(0, 2, 1),
                   right = apart(1, 3, 1);
        return glm::abs(upper.value + lower.value) + glm::abs(left.value) + glm::abs(right.value) +
               upper.radius + lower.radius + left.radius + right.radius;
    }
};

/// Cuts a box of places at the texels' centres: what is read from each piece is of the same four texels.
/// Visits the four corners of every piece, as fractions within the cell.
template <class Visit>
void at_corners(const IntervalImage& image, const WrapRules& wrap, const TexelInterval& place, Visit visit) {
    const double parts = wrap.ends_at_seams ? 2 : 1;
    const auto across = cuts_of(place.u - Interval{0.5}, parts),
               down = cuts_of(place.v - Interval{0.5}, parts);
    for (std::size_t j = 0; j + 1 < down.size(); ++j) {
        for (std::size_t i = 0; i + 1 < across.size(); ++i) {
            const double left = std::floor(across[i]), top = std::floor(down[j]);
            const glm::dvec2 inside{(across[i] + across[i + 1]) / 2, (down[j] + down[j + 1]) / 2};
            const Cell cell{image, wrap, std::int64_t(left), std::int64_t(top), inside};
            for (const double x : {across[i] - left, across[i + 1] - left})
                for (const double y : {down[j] - top, down[j + 1] - top}) visit(cell, x, y);
        }
    }
}

}  // namespace

int wrapped_index(Wrap wrap, std::int64_t index, int size) {
    if (wrap == Wrap::clamp_to_edge) return int(index < 0 ? 0 : index >= size ? size - 1 : index);
    const std::int64_t periods = index >= 0 ? index / size : -((-index - 1) / size) - 1;
    const int within = int(index - periods * size);
    return wrap == Wrap::mirrored_repeat && periods % 2 != 0 ? size - 1 - within : within;
}

IntervalImage with_range(IntervalImage image) {
    const double inf = std::numeric_limits<double>::infinity();
    image.range = {glm::dvec3{inf}, glm::dvec3{-inf}};
    for (const IntervalImage::Texel& t : image.texels)
        image.range = hull(image.range, around(t.value, t.radius));
    return image;
}

IntervalImage exact_image(const texture::LinearImage& image) {
    IntervalImage exact{image.width, image.height, {}, {}};
    exact.texels.reserve(image.texels.size());
    for (const glm::vec4& texel : image.texels) exact.texels.push_back({glm::dvec3{glm::vec3{texel}}, {}});
    return with_range(std::move(exact));
}

TexelInterval place_in(const IntervalImage& level, const IntervalImage& finest, const TexelInterval& place,
                       const FilterPrecision& precision) {
    const double unit = std::exp2(-precision.coordinate_bits), error = std::exp2(-precision.place_bits);
    const auto scaled = [&](const Interval& p, int size, int full) {
        const Interval at = size == full ? p : p * (Interval{double(size)} / Interval{double(full)});
        // An implementation rounds the quotient, the product, the difference of half a texel, and the
        // fraction.
        const double rounding = 4 * unit * (std::max(std::abs(at.low()), std::abs(at.high())) + 1);
        return widen(at + Interval{precision.level_offset}, error + rounding);
    };
    return {scaled(place.u, level.width, finest.width), scaled(place.v, level.height, finest.height)};
}

double on_lattice(double weight, const FilterPrecision& precision) {
    const auto& [bits, rounding] = precision.weights_on;
    if (std::isinf(bits)) return weight;
    const double steps = std::exp2(bits), up = rounding == WeightLattice::Rounding::nearest ? 0.5 : 0;
    return std::floor(weight * steps + up) / steps;
}

std::vector<ColourRange> nearest(const IntervalImage& image, const WrapRules& wrap,
                                 const TexelInterval& place) {
    if (is_too_wide(place)) return {image.range};
    std::vector<ColourRange> candidates;
    for (auto row = std::int64_t(std::floor(place.v.low())); double(row) <= place.v.high(); ++row) {
        for (auto column = std::int64_t(std::floor(place.u.low())); double(column) <= place.u.high();
             ++column) {
            const auto& texel = image.at(wrapped_index(wrap.u, column, image.width),
                                         wrapped_index(wrap.v, row, image.height));
            candidates.push_back(around(texel.value, texel.radius));
        }
    }
    return candidates;
}

ColourRange bilinear(const IntervalImage& image, const WrapRules& wrap, const TexelInterval& place,
                     const FilterPrecision& precision) {
    if (is_too_wide(place)) return image.range;
    const double error = std::exp2(-precision.weight_bits);
    std::optional<ColourRange> range;
    at_corners(image, wrap, place, [&](const Cell& cell, double x, double y) {
        const glm::dvec3 weights = 2 * error * cell.spread();
        ColourRange at = cell.at(on_lattice(x, precision), on_lattice(y, precision));
        at = {at.low - weights, at.high + weights};
        range = range ? hull(*range, at) : at;
    });
    return *range;
}

glm::dvec3 cost_of_splits(const IntervalImage& image, const WrapRules& wrap, const TexelInterval& place) {
    if (is_too_wide(place)) return glm::dvec3{0};  // any mean of the image is permitted already
    glm::dvec3 most{0};
    at_corners(image, wrap, place,
               [&](const Cell& cell, double, double y) { most = glm::max(most, cell.cost_of_splits(y)); });
    return most;
}

}  // namespace zproof::oracle::filter_reference
