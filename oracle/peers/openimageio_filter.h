/// OpenImageIO's texture filters (docs/filter-peers.md). A library of its own, which tests and benchmarks
/// link to and the program does not: OpenImageIO brings along 250 shared libraries, which cost every start of
/// a program that is linked to it a third of a second.
#pragma once

#include "oracle/filter_peers.h"

namespace zproof::oracle {

/// OpenImageIO's TextureSystem, with a mip chain made by its own make_texture (box) from the decoded float32
/// texels, bilinear interpolation and the conservative filter. It is given, in float32, the texture
/// coordinates and steps that each pixel of the frame sees. Throws OracleError in its words.
Picture openimageio_filtered(const Scene& scene, const View& view, const Frame& frame, PeerFilter filter,
                             const FilterSettings& settings);
/// What is declared for it: float32 throughout.
FilterPrecision openimageio_filter_precision();
std::string openimageio_version();

}  // namespace zproof::oracle
