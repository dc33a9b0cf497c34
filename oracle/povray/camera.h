/// A view's camera and clip planes as POV-Ray reads them.
#pragma once

#include <string>

#include "oracle/povray/geometry.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// camera{...}: rays through the pixels' centres, but for an aim offset of 4e-9 px.
std::string povray_camera_text(const View& view, const PovrayUnits& units);

/// clipped_by{...}: near, and far where there is one.
std::string povray_clip_text(const Camera& camera, const PovrayUnits& units);

}  // namespace zproof::oracle
