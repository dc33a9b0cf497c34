/// What a run says of the attributes that a frame gives: which are judged, which are not, and which channels
/// look like attributes and are none.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "frame/attributes.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// "attributes judged: bary, uv", then each that is not judged and why.
std::vector<std::string> attribute_remarks(const Scene& scene, const View& view, const Attributes& given,
                                           const Precision& precision);

/// "channel 'uv.x': not judged; did you mean 'uv.u'?" for each whose name is nearly an attribute's, in a
/// layer or not.
std::vector<std::string> misnamed_attributes(std::span<const std::string> channels);

}  // namespace zproof
