/// Images as the filter reference reads them: texels known within a radius, wrapped and interpolated by rules
/// of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "filters/reference/colour_range_sums.h"
#include "filters/reference/seen_texture.h"
#include "texture/linear_image.h"

namespace zproof::oracle::filter_reference {

struct WrapRules {
    Wrap u = Wrap::repeat, v = Wrap::repeat;
    /// No promise but a hypothesis: a 2 x 2 read of a repeated texture takes the texels of one period alone,
    /// that of its place.
    bool ends_at_seams = false;
};

/// The texel that stands at an index anywhere on the line (glTF 2.0, samplers; OpenGL 4.6, table 8.20).
int wrapped_index(Wrap wrap, std::int64_t index, int size);

struct IntervalImage {
    struct Texel {
        glm::dvec3 value{0}, radius{0};
    };
    int width = 0, height = 0;
    std::vector<Texel> texels;
    ColourRange range;  ///< of all texels: with_range

    const Texel& at(int column, int row) const { return texels[index(column, row)]; }
    Texel& at(int column, int row) { return texels[index(column, row)]; }

  private:
    std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(width) + std::size_t(column);
    }
};

IntervalImage with_range(IntervalImage image);

/// Level 0: the image itself, exact.
IntervalImage exact_image(const texture::LinearImage& image);

/// A place of the level: p size_level / size_0, with what the scaling and the declared bits may cost.
TexelInterval place_in(const IntervalImage& level, const IntervalImage& finest, const TexelInterval& place,
                       const FilterPrecision& precision);

/// A weight rounded as FilterPrecision::weights_on says.
double on_lattice(double weight, const FilterPrecision& precision);

/// The texels that may hold the place, in reading order; more than one on a border.
std::vector<ColourRange> nearest(const IntervalImage& image, const WrapRules& wrap,
                                 const TexelInterval& place);

/// All that the bilinear weights may give over the places, each weight as good as declared. Bilinear
/// functions over a box take their extremes at its corners, so the box is cut at the texels' centres.
ColourRange bilinear(const IntervalImage& image, const WrapRules& wrap, const TexelInterval& place,
                     const FilterPrecision& precision);

/// What it costs a read, as one of two levels, that its share is split between columns and each column's
/// between texels, every split off by e: at most e times this.
glm::dvec3 cost_of_splits(const IntervalImage& image, const WrapRules& wrap, const TexelInterval& place);

}  // namespace zproof::oracle::filter_reference
