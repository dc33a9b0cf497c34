/// What `zproof conformance` found, as a document: each promise with its figure and its verdict.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "measure/measure.h"
#include "reports/pages/document.h"
#include "reports/results.h"

namespace zproof {

/// A texture filter, held to a definition.
struct TexturePromise {
    std::string filter, promise;
    std::uint64_t pixels = 0, outside = 0;
    double error_over_bound = 0;  ///< the largest
    bool is_broken = false;
    std::string refusal{};  ///< why it was not judged; empty: it was
};

/// What was asked of a renderer beside the views.
struct MeasuredPromises {
    std::vector<measure::Finding> findings;
    std::string refusal;                     ///< why it could not be measured; empty: it was
    std::vector<TexturePromise> textures{};  ///< none: textures were not asked
};

/// Fills it in from what `zproof filters check --json` prints of one picture.
void read_filter_check(TexturePromise& promise, const std::string& json);

/// The title is the verdict. The results are of the suite and of random scenes.
document::Document conformance_document(const Results& results, const MeasuredPromises& measured);

}  // namespace zproof
