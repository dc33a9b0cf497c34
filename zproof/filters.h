/// Texture filtering: the exact truth that filters are held against.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "zproof/zproof.h"

namespace zproof::api {

/// The mean of the visible surfaces' albedo over each pixel, in linear light; background is black.
struct Truth {
    Size size;
    std::vector<float> rgb;         ///< 3 per pixel, rounded once from double
    std::vector<float> half_width;  ///< of the 95 % confidence interval of the worst channel; 0 where exact
};

/// `reconstruction` is "N" (texels are squares), "B" (bilinear), "G" (bilinear under a Gaussian of radius
/// 1 px), "GN", "M" (bilinear under Mitchell's filter: values may leave 0 to 1) or "BH" (under Blackman and
/// Harris's; docs/area-integral.md). Throws InputError for another one, and a view that is not judged.
Truth truth(const Scene& scene, const View& view, const std::string& reconstruction = "N");

/// Writes linear light, 3 values per pixel, as OpenEXR with the channels R, G and B, bit for bit. Throws
/// InputError where the length is not the size's, or the file cannot be written.
void save_picture(const std::string& file, Size size, std::span<const float> rgb);

/// Linear light, 3 values per pixel.
struct LoadedPicture {
    Size size;
    std::vector<float> rgb;
};

/// Reads the channels R, G and B of an OpenEXR file. Throws InputError where it cannot be read.
LoadedPicture load_picture(const std::string& file);

}  // namespace zproof::api
