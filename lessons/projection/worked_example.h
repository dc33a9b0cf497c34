/// The lesson's worked example: a corner of a cube from local to world space and back, by a matrix printed to
/// six decimals.
#pragma once

#include <string>
#include <vector>

#include "lessons/projection/spaces.h"

namespace zproof::study::projection {

/// One computation in numbers of one type.
struct WorkedStep {
    std::string what;              ///< "local to world"
    std::string numbers;           ///< "float32", "float64", "exact"
    std::array<double, 3> result;  ///< cut to double
    std::string printed;           ///< to six significant digits, as the lesson's program prints
    std::string lesson;            ///< what the lesson prints
};

std::vector<WorkedStep> worked_example();

}  // namespace zproof::study::projection
