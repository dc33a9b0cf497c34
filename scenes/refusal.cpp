#include "scenes/refusal.h"

#include <algorithm>

#include "scenes/scene_error.h"

namespace zproof {

std::string on_one_line(std::string_view text) {
    constexpr std::size_t longest = 300;
    std::string line(text.substr(0, longest));
    if (text.size() > longest) line += "...";
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
    return line;
}

void refuse(const std::filesystem::path& file, std::string_view place, std::string_view text) {
    throw SceneError(on_one_line(file.string()) + ": " + on_one_line(place) + ": " + on_one_line(text));
}

}  // namespace zproof
