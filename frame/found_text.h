/// What a declaration holds, as a refusal shows it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace zproof {

/// As JSON; a text that is no UTF-8 keeps its bytes.
inline std::string found_text(const nlohmann::ordered_json& found) {
    if (found.is_string()) return '"' + found.get<std::string>() + '"';
    return found.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace zproof
