/// A filter fault: one way in which a filtered picture can be wrong, and the trial that must find it.
#pragma once

#include "cli/selftest/filter_stage.h"
#include "compare/conformance.h"
#include "oracle/filter_law/filter_law.h"
#include "rasterizer/texturing.h"

namespace zproof::selftest {

/// The options of a method, as its law knows them.
oracle::FilterSettings law_settings(const texture::FilterOptions& options);
StepRule step_rule(texture::Derivatives derivatives);

/// A picture of a stage held against the law of a method.
Conformance conformance_of(const Picture& picture, const FilterStage& stage, const std::string& method,
                           const texture::FilterOptions& options,
                           texture::Derivatives derivatives = texture::Derivatives::analytic);

}  // namespace zproof::selftest
