/// All texture filters. A new one is a file in methods/ and a line here.
#pragma once

#include "texture/method.h"

namespace zproof::texture {

/// The methods in the order of docs/texture-filters.md: from the cheapest to the dearest family. Names are
/// unique.
std::span<const Method> methods();

/// Null where there is none of that name.
const Method* find_method(std::string_view name);

}  // namespace zproof::texture
