/// Cameras as computer vision states them: focal lengths and principal point in pixels, and a pose.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scenes/view.h"

namespace zproof {

/// Where the centre of the upper left pixel is, in the coordinates of the principal point.
enum class PixelCentre {
    integer,  ///< (0, 0): OpenCV
    half,     ///< (1/2, 1/2): COLMAP, NeRF, and this program
};

/// A pinhole without distortion.
struct CalibratedCamera {
    std::string name;
    int width = 0, height = 0;
    double fx = 0, fy = 0, cx = 0, cy = 0;  ///< pixels; x right, y down
    PixelCentre pixel_centre = PixelCentre::half;
    glm::dvec3 eye{0}, right{0}, down{0}, forward{0};  ///< world space
};

/// What no pose says.
struct DepthRange {
    double near_depth = 0, far_depth = 0;
};

/// By how much a view's camera is another than the one that was stated.
struct Adjustment {
    double eye = 0;   ///< the largest change of a coordinate: eyes are float32
    double axes = 0;  ///< of a component of an axis: rotations are orthonormal
};

struct ImportedView {
    View view;
    Adjustment adjustment;
};

/// The view of this camera. Throws SceneError, "camera FIELD: ...", where a number is not finite or a focal
/// length not positive, and where the axes are no rotation within 1e-4, which is what five digits give.
ImportedView view_of(const CalibratedCamera& camera, const DepthRange& range);

/// "images_0001" for "./images/0001.png".
std::string view_name_of_image(const std::string& file);

}  // namespace zproof
