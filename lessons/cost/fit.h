/// Least squares: constants from measured rows, how certain they are, and which the rows cannot tell apart.
#pragma once

#include <string>
#include <vector>

namespace zproof::study::cost {

/// measured = sum of constant[i] * factor[i].
struct Observation {
    std::vector<double> factor;
    double measured = 0;  ///< > 0
};

/// Rows are divided by what was measured: residuals are shares of it, so that a run of microseconds counts as
/// much as one of a second.
struct Fit {
    std::vector<double> constant;
    std::vector<double> standard_error;  ///< of each, from the residuals; NaN where it is not determined
    std::vector<double> determined;      ///< 1: the rows fix it; below: other constants can take its place
    int rank = 0;                        ///< constants that can be told apart, or sums of them
    double condition = 0;          ///< largest over smallest singular value but 0, columns of unit length
    std::vector<double> residual;  ///< predicted / measured - 1, row by row
    double rms_residual = 0, largest_residual = 0;
};

/// The shortest solution, in columns of unit length, of those that fit best. Throws std::invalid_argument
/// where there are fewer rows than columns, a row of another length, or a measured value that is not
/// positive.
Fit fitted(const std::vector<Observation>& rows);

/// What the constants make of a row.
double predicted(const std::vector<double>& constant, const std::vector<double>& factor);

}  // namespace zproof::study::cost
