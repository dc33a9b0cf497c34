/// JSON text from strangers.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace zproof {

/// Parses the text; depth and numbers of values and objects are bounded before any parser recurses or
/// allocates. Throws SceneError, naming the file and the byte or line, for text that is not JSON, is beyond
/// limits or escapes the character 0.
nlohmann::json parse_json(const std::filesystem::path& file, std::string_view text);

}  // namespace zproof
