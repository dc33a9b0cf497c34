/// A highlight for POV-Ray's pictures.
#pragma once

namespace zproof::oracle {

/// specular max(0, r . v)^exponent of white on top of what scenes/light.h says: r is the light's direction
/// mirrored at the normal, v points to the eye (POV-Ray's finish `phong`, documentation 3.7, 3.4.6.3.4.1).
struct PhongFinish {
    double specular = 0, exponent = 40;
};

}  // namespace zproof::oracle
