/// The families of methods, one file each.
#pragma once

#include "texture/method.h"

namespace zproof::texture {

std::vector<Method> point_methods();           ///< level 0 at one place: nearest, bilinear
std::vector<Method> separable_methods();       ///< level 0 at one place, four texels along either axis
std::vector<Method> mip_methods();             ///< one place in a mip chain
std::vector<Method> cardinality_methods();     ///< few texels of several levels, from a table
std::vector<Method> bilinear_reads_methods();  ///< few bilinear reads of several levels, from a table
std::vector<Method> ripmap_methods();          ///< one place in a chain halved along either axis by itself
std::vector<Method> sat_methods();             ///< boxes of a summed-area table
std::vector<Method> repeated_sat_methods();    ///< smoother windows of sums that are added up again and again
std::vector<Method> anisotropic_methods();     ///< several places in a mip chain, along a line
std::vector<Method> openimageio_methods();     ///< the same by OpenImageIO's own definition
std::vector<Method> feline_methods();          ///< the same, probes weighted as an ellipse's Gaussian
std::vector<Method> ewa_methods();             ///< all texels of an ellipse, in two levels
std::vector<Method> supersample_methods();     ///< level 0 at many places of the pixel
std::vector<Method> stochastic_methods();  ///< one texel a sample, drawn with the probability of its weight

}  // namespace zproof::texture
