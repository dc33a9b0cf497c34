#include <memory>

#include "filters/reference/chain.h"
#include "filters/reference/lod.h"

namespace zproof::oracle::filter_reference {

namespace {

/// Images halved i times across and j times down.
class Ripmap {
  public:
    Ripmap(const texture::LinearImage& image, const Settings& settings) : settings_(settings) {
        rows_.push_back({exact_image(image)});
        while (rows_.back()[0].height > 1)
            rows_.push_back(
                {shrunk(rows_.back()[0], image.width, half_of(rows_.back()[0].height), settings)});
        for (auto& row : rows_)
            while (row.back().width > 1)
                row.push_back(shrunk(row.back(), half_of(row.back().width), row.back().height, settings));
    }

    /// LOD of one axis: log2 of the longer of the two steps along it.
    Interval level(const Interval& a, const Interval& b, std::size_t count, const FilterPrecision& p) const {
        return level_of(log2(larger(magnitude(a), magnitude(b))), settings_, count, p);
    }

    ColourRange read(const PixelFootprint& f, const FilterPrecision& p) const {
        const Interval down = level(f.per_x.v, f.per_y.v, rows_.size(), p);
        return across_levels(down, int(rows_.size()), [&](int j) { return row(j, f, p); });
    }

  private:
    /// Affine between whole levels, whose ends hold each piece's extremes.
    static ColourRange across_levels(const Interval& level, int count, auto&& value_at) {
        const int first = int(std::floor(level.low()));
        ColourRange finer = value_at(first);
        if (first == count - 1) return finer;
        ColourRange all{glm::dvec3{std::numeric_limits<double>::infinity()},
                        glm::dvec3{-std::numeric_limits<double>::infinity()}};
        for (int k = first; k < count - 1 && double(k) <= level.high(); ++k) {
            const ColourRange coarser = value_at(k + 1);
            all = hull(all, blended(finer, coarser, clamped(level, k, k + 1.0) - Interval{double(k)}));
            finer = coarser;
        }
        return all;
    }

    ColourRange row(int j, const PixelFootprint& f, const FilterPrecision& p) const {
        const auto& images = rows_[std::size_t(j)];
        const Interval across = level(f.per_x.u, f.per_y.u, images.size(), p);
        return across_levels(across, int(images.size()), [&](int i) {
            const IntervalImage& image = images[std::size_t(i)];
            return bilinear(image, settings_.wrap, place_in(image, rows_[0][0], f.centre, p), p);
        });
    }

    Settings settings_;
    std::vector<std::vector<IntervalImage>> rows_;
};

MethodReference ripmap(const texture::LinearImage& image, const Settings& settings) {
    return
        [images = std::make_shared<const Ripmap>(image, settings)](const FilterQuery& q) -> PermittedColours {
            return {images->read(q.footprint(), q.precision)};
        };
}

}  // namespace

std::vector<Definition> ripmap_definitions() { return {{"ripmap", ripmap}}; }

}  // namespace zproof::oracle::filter_reference
