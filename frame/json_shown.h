/// JSON as an error message shows it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace zproof {

/// On one line; bytes of a typed word that are no UTF-8 become U+FFFD.
template <class Json>
std::string shown(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace zproof
