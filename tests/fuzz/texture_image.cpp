// The bytes of a texture: a PNG or a JPEG of at most 64 Ki texels, which decode quickly.
#include "scenes/texture_image.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/image_module.h"

namespace zproof::fuzz {

void read_input(Input input) {
    if (!image_fault(input).empty()) return;
    const ImageExtent extent = image_extent(input);
    if (extent.width * extent.height > 65536) return;
    may_refuse<std::runtime_error>([&] {
        const Image image = decode_image(input);
        require(image.texels.size() == extent.width * extent.height * 4, "every texel is decoded");
    });
}

}  // namespace zproof::fuzz
