/// A view of a scene as POV-Ray's scene file.
#pragma once

#include <string>

#include "oracle/povray/code.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

struct PovrayScene {
    std::string text;
    PovrayCode code;  ///< of the picture's pixels, depths in POV-Ray's units
    double scale;     ///< POV-Ray's units per scene unit
};

/// Throws OracleError where the view is beyond POV-Ray's means (povray/geometry.h, povray/code.h).
PovrayScene povray_scene(const Scene& scene, const View& view);

}  // namespace zproof::oracle
