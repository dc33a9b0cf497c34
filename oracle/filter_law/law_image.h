/// Images as the law reads them: texels known within a radius, wrapped and interpolated by rules of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/filter_law/colour_range_sums.h"
#include "oracle/filter_law/seen_texture.h"
#include "texture/linear_image.h"

namespace zproof::oracle::filter_law {

struct WrapRules {
    Wrap u = Wrap::repeat, v = Wrap::repeat;
};

/// The texel that stands at an index anywhere on the line (glTF 2.0, samplers; OpenGL 4.6, table 8.20).
int standing_at(Wrap wrap, std::int64_t index, int size);

struct LawImage {
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

LawImage with_range(LawImage image);

/// Level 0: the image itself, exact.
LawImage exact_image(const texture::LinearImage& image);

/// A place of the level: p size_level / size_0, with what the scaling and the declared bits may cost.
Place place_in(const LawImage& level, const LawImage& finest, const Place& place,
               const FilterPrecision& precision);

/// The texels that may hold the place, in reading order; more than one on a border.
std::vector<ColourRange> nearest(const LawImage& image, const WrapRules& wrap, const Place& place);

/// All that the bilinear weights may give over the places, each weight as good as declared. Bilinear
/// functions over a box take their extremes at its corners, so the box is cut at the texels' centres.
ColourRange bilinear(const LawImage& image, const WrapRules& wrap, const Place& place,
                     const FilterPrecision& precision);

}  // namespace zproof::oracle::filter_law
