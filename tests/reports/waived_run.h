/// A run with waivers, for the tests of what reports make of them.
#pragma once

#include "reports/results.h"

namespace zproof {

/// The waivers "holds", "generous", "exceeded", "expired", "unused" and "elsewhere", each in the state that
/// its name says (generous: improved), on the one view room/main: 3 hidden pixels, one of them waived by
/// "holds", and 2 wrong_depth, waived by "generous". Judged on 2026-04-10.
Results waived_run();

}  // namespace zproof
