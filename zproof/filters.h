/// Texture filtering: the exact truth that filters are held against.
#pragma once

#include <cstdint>
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

/// Linear light, 3 values per texel.
struct LevelImage {
    Size size;
    std::vector<float> rgb;
};

/// The pixels whose centres see one texture, and where. Texel (0, 0) of level 0 covers [0, 1) in u and v;
/// what lies beyond an edge is for the material's wraps to say.
struct TexturedPixels {
    std::vector<std::uint64_t> pixels;  ///< row * width + column
    std::vector<double> coordinates;    ///< u and v of each, texels of level 0
    std::vector<double> jacobian;       ///< du/dx, du/dy, dv/dx, dv/dy of each, texels per pixel
    std::vector<LevelImage> levels;     ///< the box mip chain; level 0 is the texture
};

/// What a texture filter of one's own is asked for.
struct FilterTask {
    Size size;
    std::vector<double> factor;  ///< 3 per pixel: of the base colour seen there, to be multiplied by what the
                                 ///< filter says of its texture; 0 where nothing is seen
    std::vector<TexturedPixels> textures;
};

/// In exact geometry, as zproof's own filters are asked. Throws InputError for a view that is not judged.
FilterTask filter_task(const Scene& scene, const View& view);

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
