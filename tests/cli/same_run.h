/// Two folders of results, held to be of one run.
#pragma once

#include "tests/cli/program.h"

namespace zproof::test {

/// Expects the same files below either folder, byte for byte but for times.
void expect_same_run(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace zproof::test
