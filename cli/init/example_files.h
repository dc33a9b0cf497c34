#pragma once

#include <string_view>

namespace zproof {

/// The text of a file of examples/: "caster.cpp". The file must be one that cli/CMakeLists.txt names.
std::string_view example_file(std::string_view name);

}  // namespace zproof
