#include "compare/pixel_class.h"

namespace zproof {

std::string_view name_of(PixelClass c) {
    constexpr std::array<std::string_view, pixel_class_count> names{
        "agree",       "edge", "depth_tie", "abutting_edges", "clip",   "reference_wrong",
        "wrong_depth", "hole", "outside",   "hidden",         "invalid"};
    return names[std::size_t(c)];
}

}  // namespace zproof
