/// The variants' scenes and pictures, one family in each file.
#pragma once

#include "measure/selfcheck/variant.h"

namespace zproof::measure {

// order.cpp
Scene in_reversed_order(const Scene& scene);
std::vector<VariantPicture> pictures_of_reversed_order(const Scene& scene, const View& view);
Scene wound_the_other_way(const Scene& scene);
std::vector<VariantPicture> same_picture(const Scene& scene, const View& view);

// split.cpp
Scene split_in_two(const Scene& scene);
std::vector<VariantPicture> pictures_of_halves(const Scene& scene, const View& view);

// window.cpp
Scene same_scene(const Scene& scene);
std::vector<VariantPicture> moved_by_whole_pixels(const Scene& scene, const View& view);
std::vector<VariantPicture> cut_into_tiles(const Scene& scene, const View& view);
std::vector<VariantPicture> three_times_as_large(const Scene& scene, const View& view);

// mirror.cpp
Scene mirrored(const Scene& scene);
std::vector<VariantPicture> mirrored_picture(const Scene& scene, const View& view);

}  // namespace zproof::measure
