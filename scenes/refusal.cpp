#include "scenes/refusal.h"

#include "frame/printable.h"
#include "scenes/scene_error.h"

namespace zproof {

std::string on_one_line(std::string_view text) { return shortened(text, longest_line_bytes); }

void refuse(const std::filesystem::path& file, std::string_view place, std::string_view text) {
    throw SceneError(on_one_line(file.string()) + ": " + on_one_line(place) + ": " + on_one_line(text));
}

}  // namespace zproof
