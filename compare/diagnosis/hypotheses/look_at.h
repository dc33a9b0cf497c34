/// Where in a renderer's code to look first, by the cause's name.
#pragma once

#include <string>
#include <string_view>

namespace zproof {

/// One sentence; empty for a name that no hypothesis has.
std::string look_at(std::string_view name);

}  // namespace zproof
