#include "frame/frame_error.h"
#include "frame/number_text.h"

namespace zproof {

void refuse_bad_size(Resolution size, const std::string& place) {
    constexpr int largest_side = 32768;
    const auto allowed = [](int side) { return side >= 1 && side <= largest_side; };
    if (allowed(size.width) && allowed(size.height)) return;
    throw FrameError(place + ": size " + size_text(size.width, size.height) + "; expected 1 to " +
                     std::to_string(largest_side) + " pixels on either side");
}

}  // namespace zproof
