/// scenes/suite/manifest.json as it was when the library was built.
#pragma once

#include <string_view>

namespace zproof::suite {

std::string_view manifest_json();

}  // namespace zproof::suite
