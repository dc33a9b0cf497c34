/// What `zproof fit` found, as a document and as JSON (docs/fit.md).
#pragma once

#include <string>
#include <vector>

#include "measure/fit/fit.h"
#include "reports/pages/document.h"

namespace zproof {

struct FittedView {
    std::string scene, view;
    measure::ViewFit fit;
};

/// The promise that covers all views; there must be one.
BoundedPrecision promise_of(const std::vector<FittedView>& views);

/// Is every pixel of every view admissible under it?
bool explains_all(const std::vector<FittedView>& views);

/// Title, introduction and sections: the promise, the figures view by view, the curve, what is left out.
document::Document fit_document(const std::string& renderer, const std::vector<FittedView>& views);

/// fit.json, UTF-8, ending in a newline. Figures keep every bit.
std::string fit_json(const std::string& renderer, const std::vector<FittedView>& views);

}  // namespace zproof
