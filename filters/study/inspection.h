/// What a method reads at one pixel, held against what the pixel covers: the reason of its error, in numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/bounds/pixel_coord.h"
#include "filters/area/area_weights.h"
#include "filters/methods/recorder.h"
#include "filters/study/cost.h"
#include "filters/study/plan.h"
#include "filters/study/texture_window.h"
#include "frame/frame.h"

namespace zproof::study {

/// Taps of one stored image.
struct ImageRead {
    int image = 0, width = 0, height = 0;
    std::size_t taps = 0;
    double weight = 0;  ///< sum over its taps
    /// log2 of level 0's size over its own, along u and v; none where its values are no means of level 0
    /// (sums of a summed-area table).
    std::optional<glm::dvec2> level;
};

/// A tap and the stored value that it reads, linear RGB.
struct ValuedTap {
    texture::Tap tap;
    glm::dvec3 value{0};
};

/// What the weights' first two moments tell of an error.
enum class WeightFault {
    blur,   ///< they spread wider than the exact ones along an axis
    alias,  ///< narrower
    shift,  ///< their centroid lies elsewhere
};

/// Along an axis of the footprint's ellipse. Lengths in texels.
struct WeightFinding {
    WeightFault fault = WeightFault::blur;
    bool is_along_major = false;  ///< else along the minor axis
    double found = 0, exact = 0;  ///< standard deviations; of a shift, the distance and 0
};

/// What a method reads. Nobody records what others' samplers read.
struct Reading {
    std::vector<ValuedTap> taps;  ///< in reading order
    std::vector<ImageRead> images;
    texture::Kernel kernel;
    texture::KernelShape shape;
};

/// The area integral's weights on the same texture.
struct ExactWeights {
    texture::Kernel kernel;
    texture::KernelShape shape;
    glm::dvec3 mean{0};  ///< of the texels under these weights, without the factor
    bool wraps = false;  ///< they reach over more than a period: their moments tell nothing
};

struct PixelInspection {
    int x = 0, y = 0;
    std::string label;
    int texture_width = 0, texture_height = 0;  ///< 0: no texture is seen there
    glm::dvec3 factor{1};                       ///< of the material
    texture::Footprint footprint;
    texture::Ellipse ellipse;
    std::optional<Reading> reading;     ///< none: of a sampler of others, of given levels, of a large table
                                        ///< of repeated sums, or no texture
    std::optional<ExactWeights> exact;  ///< none: the truth is sampled, or no texture
    std::vector<WeightFinding> findings;
    TextureWindow window;  ///< of no size where there is no texture
    glm::dvec3 result{0};  ///< factor x the sum of weight x value
};

/// A window's cells along either side.
inline constexpr int most_window_cells = 32;

/// Moments that differ by less are alike: levels are stored as float32, with 24 bits.
inline constexpr double alike = 0x1p-20;

/// Compares the moments, axis by axis; nothing where one of them is not known or means nothing.
std::vector<WeightFinding> findings_of(const texture::Ellipse& ellipse, const texture::KernelShape& found,
                                       const texture::KernelShape& exact);

/// One view's inspections. Scene, view and frame must outlive it.
class Inspector {
  public:
    /// `frame`: the surfaces that pictures of the study show.
    Inspector(const Scene& scene, const View& view, const Frame& frame, oracle::Reconstruction truth);

    /// Pixels of one method, in their order, on the threads of the surrounding tbb::task_arena.
    std::vector<PixelInspection> at(const StudyMethod& method, const std::vector<PixelCoord>& pixels) const;

  private:
    /// A pixel without its weights.
    struct Seen {
        PixelInspection inspection;
        int material = -1;  ///< -1: no texture
    };
    Seen seen_at(const StudyMethod& method, const PixelCoord& pixel) const;
    void weigh(Seen& seen) const;

    const Scene& scene_;
    const View& view_;
    const Frame& frame_;
    SourceTextures sources_;
    oracle::AreaWeights weights_;
};

}  // namespace zproof::study
