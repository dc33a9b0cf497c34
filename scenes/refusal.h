/// The one way in which this room says no.
#pragma once

#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>

namespace zproof {

/// Text on one line, safe to show (frame/printable.h), of at most 300 bytes.
std::string on_one_line(std::string_view text);

/// The JSON pointer to an element of a list of the file, and to what is in it.
std::string pointer(const std::string& list, std::integral auto index, const std::string& inside = "") {
    return "/" + list + "/" + std::to_string(index) + inside;
}

/// Throws SceneError("FILE: PLACE: TEXT"). The place is a JSON pointer or a few words; the text says what was
/// expected and, where there is a remedy, which.
[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view place, std::string_view text);

}  // namespace zproof
