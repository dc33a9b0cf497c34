#include "filters/reference/chain.h"
#include "filters/reference/surface_areas.h"

namespace zproof::oracle::filter_reference {

namespace {

struct WeighedImage {
    IntervalImage image;
    std::vector<Interval> shares;  ///< what each texel counts for, not negative
};

/// A texel and what it counts for.
struct WeighedTexel {
    IntervalImage::Texel texel;
    Interval share;
};

/// The mean of the sources, each by the kernel's weight times its share: docs/filter-conformance.md,
/// "Weighted means". Where the shares may sum to nothing, the kernel's mean and any other are permitted.
WeighedTexel weighed(const WeighedImage& finer, const Sources& columns, const Sources& rows,
                     const StoredUnit& unit) {
    const IntervalImage::Texel plain = made_of(finer.image, columns, rows, unit);
    Interval share{0};
    glm::dvec3 sum{0};
    double middle_sum = 0;
    ColourRange any = around(plain.value, plain.radius);
    const auto each = [&](auto&& visit) {
        for (const Source& row : rows)
            for (const Source& column : columns) {
                const auto at =
                    std::size_t(row.index) * std::size_t(finer.image.width) + std::size_t(column.index);
                visit(finer.image.texels[at], row.weight * column.weight * finer.shares[at]);
            }
    };
    each([&](const IntervalImage::Texel& texel, const Interval& weight) {
        share = share + weight;
        sum += middle(weight) * texel.value;
        middle_sum += middle(weight);
        if (weight.high() > 0) any = hull(any, around(texel.value, texel.radius));
    });
    if (share.high() <= 0) return {plain, Interval{0}};
    if (share.low() <= 0)
        return {{(any.low + any.high) / 2.0, (any.high - any.low) / 2.0}, clamped(share, 0, 1)};
    const glm::dvec3 mean = sum / middle_sum;
    glm::dvec3 off{0}, size{0};
    each([&](const IntervalImage::Texel& texel, const Interval& weight) {
        off += radius(weight) * glm::abs(texel.value - mean) + weight.high() * texel.radius;
        size += weight.high() * (glm::abs(texel.value) + texel.radius);
    });
    // The stored format; 9 terms at most, theirs and ours, each with its weight's few roundings.
    return {{mean, (off + (unit.relative + 64 * 0x1p-53) * size) / share.low() + unit.least}, share};
}

}  // namespace

std::vector<IntervalImage> chain_by_area(const texture::LinearImage& image, const Settings& settings) {
    Settings own = settings;
    if (own.kernel == ChainKernel::lanczos3 || own.kernel == ChainKernel::kaiser3)
        own.kernel = ChainKernel::polyphase;
    WeighedImage level{exact_image(image), {}};
    if (settings.scene != nullptr && !settings.given_levels)
        level.shares = area_shares(*settings.scene, settings.image);
    if (level.shares.empty()) return chain(image, own);
    const StoredUnit unit = stored_unit(settings.texel_bits);
    std::vector<IntervalImage> levels{level.image};
    while (level.image.width > 1 || level.image.height > 1) {
        const int width = half_of(level.image.width), height = half_of(level.image.height);
        WeighedImage coarser{{width, height, {}, {}}, {}};
        const auto columns = all_sources(own.kernel, {level.image.width, width, own.wrap.u}),
                   rows = all_sources(own.kernel, {level.image.height, height, own.wrap.v});
        for (const Sources& row : rows)
            for (const Sources& column : columns) {
                const auto [texel, share] = weighed(level, column, row, unit);
                coarser.image.texels.push_back(texel);
                coarser.shares.push_back(share);
            }
        coarser.image = with_range(std::move(coarser.image));
        levels.push_back(coarser.image);
        level = std::move(coarser);
    }
    return levels;
}

}  // namespace zproof::oracle::filter_reference
