/// The offsets with which a definition shows a picture best: least squares, iterated (Gauss and Newton),
/// since a picture does not answer to large offsets as to small ones.
#pragma once

#include "filters/conformance/joint_samples.h"

namespace zproof {

/// Sums over rows, then over columns, of pixels.
struct Blocks {
    std::vector<double> rows, columns;

    explicit Blocks(const Resolution& size)
        : rows(std::size_t(size.height)), columns(std::size_t(size.width)) {}
    void add(const FilterPixel& p, double value) {
        rows[std::size_t(p.y)] += value, columns[std::size_t(p.x)] += value;
    }
};

/// The larger of both sums' standard errors (cluster-robust: pixels of a block may err together).
double standard_error(const Blocks& errors);

struct OffsetFit {
    std::vector<double> offsets, standard_errors;  ///< 0 for those that are not told
    bool has_converged = false;                    ///< a further step is small beside the standard errors
    Values residual;                               ///< the picture less the definition with all offsets
    std::vector<Values> residual_without;          ///< by offset: with all but that one
};

/// Where the steps do not converge the first one is returned, of the picture's linear answer.
OffsetFit fit_offsets(const Picture& picture, const Samples& samples, const JointReferences& references);

}  // namespace zproof
