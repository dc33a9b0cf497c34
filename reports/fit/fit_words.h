/// The sentences about a fit.
#pragma once

#include <string>
#include <string_view>

#include "measure/fit/fit.h"

namespace zproof {

/// "eps 0.00212 px explains all but 3 pixels; those need 0.7 px: look at (12, 7), (80, 3)"; with another for
/// every other reason to leave pixels out. Where none is left out: "eps 0.00212 px explains every pixel".
std::string fit_in_words(const measure::ViewFit& fit);

/// "alone_by_place"
std::string_view name_of(measure::LeftOut::Reason reason);

}  // namespace zproof
