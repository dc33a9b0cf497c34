/// What a pixel of the picture that POV-Ray makes for us says: a triangle and its depth, as one number of 48
/// bits in three channels of 16.
///
/// Low to high: 1 + id in `id_bits` bits (0 = background), then the depth's step. So red holds the lower 16
/// bits of the id, green its upper bits and the lower ones of the depth, blue the rest.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "frame/frame.h"

namespace zproof::oracle {

/// How steps stand to depths.
enum class DepthSteps {
    logarithmic,  ///< equal ratios: a relative error
    linear,       ///< equal differences: an absolute error
};

class PovrayCode {
  public:
    /// Codes ids below triangle_count and depths from `low` to `high` (0 < low where logarithmic). Throws
    /// OracleError where too few bits are left for depths to be within 2^-24 (linear: 2^-29 of the range).
    PovrayCode(std::size_t triangle_count, DepthSteps steps, double low, double high);

    using Channels = std::array<std::uint16_t, 3>;
    struct Pixel {
        PrimitiveId primitive;
        double depth;  ///< +inf for background
    };
    /// Throws OracleError where the channels hold no code: an id that is none, a background with a depth.
    Pixel decoded(const Channels& channels) const;

    /// The part of an id, as POV-Ray's colour: red and green, 0 to 1.
    std::array<double, 2> colour_of(PrimitiveId primitive) const;

    /// POV-Ray's declarations of the pigments Lower and Upper: the depth's part in green and in blue, four
    /// times as bright. `depth` is an expression in x, y and z.
    std::string depth_pigments(const std::string& depth) const;

  private:
    int id_bits_, depth_bits_;
    std::size_t triangle_count_;
    DepthSteps steps_;
    double low_, high_;
    double span_;     ///< what the steps divide: ln(high / low), or high - low
    double highest_;  ///< the last step
};

}  // namespace zproof::oracle
