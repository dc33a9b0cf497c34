/// Whole numbers of JSON that anybody may have written. nlohmann's own conversions take every number: one
/// that does not fit becomes another, and a large one with a point is undefined.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace zproof {

/// Is it a whole number that the type has?
template <std::integral Number, class Json>
bool holds_whole_number(const Json& json) {
    if (json.is_number_unsigned()) return std::in_range<Number>(json.template get<std::uint64_t>());
    return json.is_number_integer() && std::in_range<Number>(json.template get<std::int64_t>());
}

/// Throws nlohmann's type_error where it is none.
template <std::integral Number, class Json>
Number whole_number(const Json& json) {
    using Limits = std::numeric_limits<Number>;
    if (holds_whole_number<Number>(json)) return json.template get<Number>();
    throw Json::type_error::create(302,
                                   "expected a whole number from " + std::to_string(Limits::min()) + " to " +
                                       std::to_string(Limits::max()) + ", found " +
                                       json.dump(-1, ' ', false, Json::error_handler_t::replace),
                                   &json);
}

}  // namespace zproof
