/// What `zproof conformance` found, as a document: each promise with its figure and its verdict.
#pragma once

#include <span>
#include <string>

#include "measure/measure.h"
#include "reports/pages/document.h"
#include "reports/results.h"

namespace zproof {

/// What was asked of a renderer beside the views.
struct MeasuredPromises {
    std::vector<measure::Finding> findings;
    std::string refusal;  ///< why it could not be measured; empty: it was
};

/// The title is the verdict. The results are of the suite and of random scenes.
document::Document conformance_document(const Results& results, const MeasuredPromises& measured);

}  // namespace zproof
