#pragma once

#include <string>

#include "reports/results.h"

namespace zproof {

/// Seconds of wall clock per stage, over all views, each with its share. Ends in a newline.
std::string times_table(const Results& results);

}  // namespace zproof
