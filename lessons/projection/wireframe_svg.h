/// Wireframes as SVG files of their own, over a picture where there is one.
#pragma once

#include <optional>
#include <string>

#include "frame/picture.h"
#include "frame/plane.h"
#include "lessons/projection/edge_distance.h"
#include "lessons/projection/wireframe.h"

namespace zproof {

struct WireframeDrawing {
    const study::projection::Wireframe& wireframe;
    Resolution size;                        ///< of the picture
    const Plane<Rgb8>* backdrop = nullptr;  ///< drawn beneath, pixel (x, y) from (x, y) to (x + 1, y + 1)
};

/// More lines than these are not drawn: the longest are.
inline constexpr std::size_t most_lines = 20'000;

/// The whole picture. Without a backdrop hidden lines are drawn thin and grey, over one they are left out.
std::string wireframe_svg(const WireframeDrawing& drawing);

/// "The longest 20,000 of 31,415 lines are drawn."; empty where all are.
std::string remark_on_lines(const study::projection::Wireframe& wireframe);

/// The square of 2 reach pixels around a place, magnified: the backdrop's pixels with their centres, all
/// lines, and the pair of centres that the boundary is about.
std::string magnified_svg(const WireframeDrawing& drawing, const study::projection::Boundary& boundary,
                          int reach);

}  // namespace zproof
