/// What `zproof measure` found, for people and for programs.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "measure/measure.h"

namespace zproof {

/// A line per finding: measured, declared, and whether it is kept; then a verdict. A number is given as the
/// middle of its bracket and half the bracket's width. Ends in a newline.
std::string measurement_table(const std::string& renderer, std::span<const measure::Finding> findings);

/// The words of its columns: what was measured, and whether it is kept ("as declared", "WORSE", "-").
std::string measured_in_words(const measure::Finding& finding);
std::string_view in_words(measure::Conformity conformity);

/// The findings as JSON, UTF-8, ending in a newline; docs/measure.md tells its shape. Brackets keep every
/// bit.
std::string measurement_json(const std::string& renderer, std::span<const measure::Finding> findings);

}  // namespace zproof
