#include "measure/selfcheck/variants.h"

#include <array>

namespace zproof::measure {

std::span<const Variant> variants() {
    using enum Variant::Numbers;
    static const std::array all{
        Variant{"reversed order", "triangles are told from the last to the first", same, in_reversed_order,
                pictures_of_reversed_order},
        Variant{"other winding", "two corners of every triangle change places", same, wound_the_other_way,
                same_picture},
        Variant{"split in two", "every triangle is cut in the middle of its first edge", rounded,
                split_in_two, pictures_of_halves},
        Variant{"moved by whole pixels", "the window begins 7 columns and 5 rows later", rounded, same_scene,
                moved_by_whole_pixels},
        Variant{"mirrored", "scene, camera and window are turned over in x", same, mirrored,
                mirrored_picture},
        Variant{"three times as large", "each pixel's centre is that of the middle one of nine", same,
                same_scene, three_times_as_large},
        Variant{"cut into tiles", "the window is cut into four pictures", rounded, same_scene,
                cut_into_tiles},
    };
    return all;
}

}  // namespace zproof::measure
