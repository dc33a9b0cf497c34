#include "oracle/convention/expected_size.h"

#include <string>

#include "frame/frame_error.h"

namespace zproof::oracle {

void refuse_other_size(const std::filesystem::path& file, Resolution size, const View& view) {
    if (size == Resolution{view.width, view.height}) return;
    throw FrameError(file.string() + ": " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                     " pixels; the view '" + view.name + "' has " + std::to_string(view.width) + " x " +
                     std::to_string(view.height));
}

}  // namespace zproof::oracle
