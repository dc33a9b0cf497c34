#include "filters/reference/levels.h"

#include <memory>
#include <optional>

namespace zproof::oracle::filter_reference {

Levels::Levels(const texture::LinearImage& image, const Settings& settings)
    : settings_(settings), levels_(chain_of(image, settings)) {}

Levels::Levels(std::vector<IntervalImage> levels, const Settings& settings)
    : settings_(settings), levels_(std::make_shared<const std::vector<IntervalImage>>(std::move(levels))) {}

PermittedColours Levels::nearest_in(int level, const TexelInterval& place,
                                    const FilterPrecision& precision) const {
    return nearest(at(level), settings_.wrap, place_in(at(level), at(0), place, precision));
}

ColourRange Levels::bilinear_in(int level, const TexelInterval& place,
                                const FilterPrecision& precision) const {
    return bilinear(at(level), settings_.wrap, place_in(at(level), at(0), place, precision), precision);
}

glm::dvec3 Levels::cost_of_splits_in(int level, const TexelInterval& place,
                                     const FilterPrecision& precision) const {
    return cost_of_splits(at(level), settings_.wrap, place_in(at(level), at(0), place, precision));
}

/// Piecewise affine in the LOD: cut at whole levels, the ends of each piece hold its extremes.
ColourRange Levels::trilinear(const Interval& level, const TexelInterval& place,
                              const FilterPrecision& precision) const {
    const int coarsest = int(count()) - 1, first = int(std::floor(level.low()));
    const double error = std::exp2(-precision.weight_bits);
    ColourRange finer = bilinear_in(first, place, precision);
    if (first == coarsest) return finer;
    std::optional<ColourRange> range;
    for (int k = first; k < coarsest && double(k) <= level.high(); ++k) {
        const ColourRange coarser = bilinear_in(k + 1, place, precision);
        const Interval fraction = clamped(level, k, k + 1.0) - Interval{double(k)};
        const Interval rounded{on_lattice(fraction.low(), precision), on_lattice(fraction.high(), precision)};
        const Interval share = clamped(widen(rounded, error), 0, 1);
        ColourRange piece = blended(finer, coarser, share);
        if (precision.split_bits < FilterPrecision::exact && fraction.high() > 0) {
            const glm::dvec3 splits =
                std::exp2(-precision.split_bits) *
                (cost_of_splits_in(k, place, precision) + cost_of_splits_in(k + 1, place, precision));
            piece = {piece.low - splits, piece.high + splits};
        }
        range = range ? hull(*range, piece) : piece;
        finer = coarser;
    }
    return *range;
}

std::function<MethodReference(const texture::LinearImage&, const Settings&)> over_levels(
    std::function<PermittedColours(const Levels&, const FilterQuery&)> reference) {
    return [reference = std::move(reference)](const texture::LinearImage& image,
                                              const Settings& settings) -> MethodReference {
        return [levels = std::make_shared<const Levels>(image, settings), reference](const FilterQuery& q) {
            return reference(*levels, q);
        };
    };
}

}  // namespace zproof::oracle::filter_reference
