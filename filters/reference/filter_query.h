/// What a definition is asked, and what it reads.
#pragma once

#include <functional>
#include <memory>

#include "filters/reference/interval_image.h"
#include "filters/reference/permitted_colours.h"

namespace zproof::oracle::filter_reference {

/// How the smaller levels of a mip chain are made.
enum class ChainKernel { box, polyphase, lanczos3, kaiser3 };

/// What a chain's levels are kept as.
enum class LevelFormat {
    float32,
    float16,            ///< levels above 0
    float16_throughout  ///< and level 0
};

/// Where codes are made linear light. All but the first are wrong.
enum class Decoding { before_filtering, after_filtering, never, twice };

class SharedImages;

/// What a user may set of a method.
struct Settings {
    WrapRules wrap;
    ChainKernel kernel = ChainKernel::polyphase;
    double lod_bias = 0;                 ///< added before clamping
    double lod_min = 0, lod_max = 1000;  ///< clamp of the biased LOD
    int max_anisotropy = 16;
    int subdivisions = 4;
    int samples = 1;         ///< a pixel's, of stochastic methods
    std::uint32_t seed = 0;  ///< the first frame, of a method whose numbers are defined
    std::shared_ptr<const std::vector<texture::LinearImage>>
        given_levels{};      ///< 1 and on; null: made by kernel
    double texel_bits = 24;  ///< unit roundoff of levels above 0
    LevelFormat format = LevelFormat::float32;
    Decoding decoding = Decoding::before_filtering;
    int more_taps = 0;             ///< along a line than the definition has
    glm::ivec2 more_texels{0, 0};  ///< that a summed box reaches to the right and down than its area has
    /// Whose triangles show the texture, its image of this index; null: not known.
    const Scene* scene = nullptr;
    int image = 0;
    std::shared_ptr<SharedImages> shared{};  ///< with other references; null: with none
    double texel_error =
        0;  ///< stored texels of level 0 are rounded by at most this much (a table of integers)
};

/// One pixel of a surface.
struct FilterQuery {
    const SeenTexture& seen;
    int x = 0, y = 0;
    StepRule steps = StepRule::analytic;
    const FilterPrecision& precision;

    PixelFootprint footprint() const { return seen.footprint(x, y, steps); }
};

/// A texture made ready for one definition. Throws UndecidedSign where intervals cannot tell.
using MethodReference = std::function<PermittedColours(const FilterQuery&)>;

/// What a stochastic definition may draw.
using DrawReference = std::function<ColourDraws(const FilterQuery&)>;

struct Definition {
    std::string name;
    std::function<MethodReference(const texture::LinearImage&, const Settings&)> prepare;
    std::function<DrawReference(const texture::LinearImage&, const Settings&)>
        draws{};  ///< of a stochastic one
};

std::vector<Definition> point_definitions();
std::vector<Definition> separable_definitions();
std::vector<Definition> mip_definitions();
std::vector<Definition> cardinality_definitions();
std::vector<Definition> bilinear_reads_definitions();
std::vector<Definition> ripmap_definitions();
std::vector<Definition> anisotropic_definitions();
std::vector<Definition> openimageio_definitions();
std::vector<Definition> ewa_definitions();
std::vector<Definition> sat_definitions();
std::vector<Definition> repeated_sat_definitions();
std::vector<Definition> supersample_definitions();
std::vector<Definition> stochastic_definitions();

}  // namespace zproof::oracle::filter_reference
