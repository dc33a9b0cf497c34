#include "image_io/frame_files.h"

#include <string>

namespace zproof::image_io {

namespace fs = std::filesystem;

FrameFiles frame_files(const fs::path& named) {
    const std::string text = named.string();
    const auto is_there = [](const fs::path& file) {
        std::error_code ignored;
        return fs::exists(fs::symlink_status(file, ignored));
    };
    if (is_there(named)) return {named, named};
    for (std::size_t at = text.find('+'); at != std::string::npos; at = text.find('+', at + 1)) {
        FrameFiles two{text.substr(0, at), text.substr(at + 1)};
        if (is_there(two.ids) && is_there(two.depths)) return two;
    }
    return {named, named};
}

}  // namespace zproof::image_io
