#include "filters/commands/commands.h"
#include "filters/selftest/filter_fault.h"

namespace zproof {

ExitCode execute(const FiltersSelftestArguments& arguments) {
    return selftest::score_told(arguments.common, selftest::filter_test_count(), selftest::try_filters);
}

}  // namespace zproof
