/// What a texture filter is: a footprint rule, a LOD rule and a tap rule, told in its definition card and
/// carried out by its sampler. Every method here is linear in the texels: its result is a weighted sum of
/// stored values. The weights of a stochastic method depend on the pixel and a seed, too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "texture/footprint.h"
#include "texture/linear_image.h"
#include "texture/surface.h"

namespace zproof::texture {

/// One read: a stored value and its weight in the result.
struct Tap {
    int image = 0;            ///< index into Sampler::stored
    int column = 0, row = 0;  ///< within it, after wrapping
    double weight = 0;
};

/// The share that each texel of a rectangle of level 0 has in a stored value: in a level of a mip chain about
/// 1 / texels, in a sum of a summed-area table 1. Rectangles of one value may overlap; their shares add.
struct Share {
    int column = 0, row = 0;  ///< the rectangle's first texel
    double weight = 0;        ///< of each texel
    int columns = 1, rows = 1;
};

/// What a sampler keeps: a level of a mip chain, a summed-area table.
struct StoredImage {
    int width = 0, height = 0;
    std::size_t bytes_per_texel = 0;
    /// The level-0 texels that a stored value is made of: what the weight recorder expands a tap to.
    /// Empty where nobody is told.
    std::function<std::vector<Share>(int column, int row)> made_of;
};

/// A texture made ready for one method. Immutable: may be asked from many threads. Footprints
/// must be finite; of others the result means nothing, but reads stay within the stored images and few.
struct Sampler {
    std::function<glm::dvec4(const Footprint&)> colour;  ///< linear RGBA; not clamped
    /// The colours of many footprints, into as many elements: faster, with the same bits. If it is empty,
    /// look_up() calls `colour` for each.
    std::function<void(std::span<const Footprint>, std::span<glm::dvec4>)> colours{};
    std::function<std::vector<Tap>(const Footprint&)>
        taps;  ///< the reads behind that colour, in reading order
    std::vector<StoredImage> stored;
};

/// The colours of many footprints; colours.size() == seen.size().
void look_up(const Sampler& sampler, std::span<const Footprint> seen, std::span<glm::dvec4> colours);

/// How the smaller levels of a mip chain are made.
enum class MipKernel {
    box,        ///< 2 x 2 means; an odd size drops its last column or row (OpenGL's common way)
    polyphase,  ///< box whose weights vary with the place where a size is odd (Guthe and Heckbert, NVIDIA
                ///< TR-01838)
    lanczos3,   ///< Lanczos-windowed sinc of three lobes
    kaiser3,    ///< Kaiser-windowed sinc of three lobes, alpha 4 (NVIDIA Texture Tools)
};

/// How a summed-area table keeps its sums.
enum class SatStorage { integer, float64, float32, float32_less_mean };

/// Where a texture's sRGB codes are made linear light.
enum class Decoding {
    before_filtering,
    after_filtering,  ///< the wrong way, for comparison: codes are filtered
};

/// What a user may set; a method reads what it has a use for.
struct FilterOptions {
    Addressing addressing{};
    MipKernel mip_kernel = MipKernel::polyphase;
    SatStorage sat_storage = SatStorage::float64;
    double lod_bias = 0;                 ///< added before clamping
    double lod_min = 0, lod_max = 1000;  ///< clamp of the biased LOD
    Decoding decoding =
        Decoding::before_filtering;  ///< heeded by who prepares the image and shows the result
    int max_anisotropy = 16;         ///< 1 to 64
    int subdivisions = 4;            ///< n of n x n sub-quads, strips or supersamples
    int samples = 1;                 ///< a pixel's, of stochastic methods; 1 to 1024
    std::uint32_t seed = 0;          ///< of their noise
    /// Levels 1 and on of a chain that is given, as mip_chain() requires them; null: made by mip_kernel.
    std::shared_ptr<const std::vector<LinearImage>> given_levels{};
    Surface surface{};  ///< that shows the texture; null: not known
};

/// The definition as a reader needs it; docs/texture-filters.md is made of these.
struct DefinitionCard {
    std::string footprint, lod, taps;  ///< the three rules, one sentence each
    std::string source;                ///< paper, specification section, or "ours"
};

struct Method {
    std::string name;  ///< as --filter and --methods know it: lower case, '-'
    DefinitionCard card;
    std::function<Sampler(const LinearImage&, const FilterOptions&)> prepare;
};

}  // namespace zproof::texture
