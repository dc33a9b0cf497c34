/// An interpolated value that no faultless renderer gives.
#pragma once

#include <cstddef>

namespace zproof {

struct WrongAttribute {
    std::size_t channel = 0;  ///< of attribute_channels
    float value = 0;
    double low = 0, truth = 0, high = 0;  ///< the admissible values, and that at the centre; for people
    double error_over_bound = 0;          ///< |value - truth| over the bound on that side
};

}  // namespace zproof
