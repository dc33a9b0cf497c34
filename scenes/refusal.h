/// The one way in which this room says no.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace zproof {

/// Text on one line: control characters become '?', and what is longer than 300 bytes is cut.
std::string on_one_line(std::string_view text);

/// Throws SceneError("FILE: PLACE: TEXT"). The place is a JSON pointer or a few words; the text says what was
/// expected and, where there is a remedy, which.
[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view place, std::string_view text);

}  // namespace zproof
