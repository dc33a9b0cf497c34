/// A precision that a renderer can promise, found from what was measured.
#pragma once

#include <stdexcept>

#include "measure/measure.h"

namespace zproof::measure {

/// What was measured fits no precision of the declared kind.
struct NoPromise : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The declared precision, with what the pictures show in the place of what was declared: the finest
/// sub-pixel grid, its snap, and no more depth roundings than the depths need, but at least those that are
/// declared. Of a ray caster the pictures show none of its keys: it comes back as declared. Throws NoPromise,
/// naming what no promise covers.
Precision measured_promise(const Measurement& measurement, const Precision& declared);

}  // namespace zproof::measure
