/// Measures a renderer and tells how far that is.
#pragma once

#include "measure/measure.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"

namespace zproof {

struct MeasurementRun {
    measure::Measurement measurement;
    Share instruments;  ///< those that read what they can, of all: fewer where it was interrupted
};

/// Throws what the renderer throws.
MeasurementRun measured(const measure::Renderer& renderer, const CommonArguments& common);

}  // namespace zproof
