/// A sphere cut into more and more triangles, and what shading makes of it.
#pragma once

#include <vector>

#include "lessons/shading/methods.h"
#include "scenes/loaded.h"

namespace zproof::study::shading {

/// The unit sphere at the origin: an icosahedron, each triangle cut in four `level` times, corners on the
/// sphere, their normals the sphere's own. 20 * 4^level triangles. The eye is at (0, 0, 4); side_px square.
Loaded sphere(int level, int side_px);

/// The sphere itself, seen by exact rays: what the triangles stand for. NaN beside it.
Plane<double> round_picture(const View& view, const Lighting& lighting);

/// One method on one tessellation, against the sphere itself, over pixels that both show.
struct LevelScore {
    int level = 0;
    std::size_t triangles = 0;
    double edge_px = 0;  ///< median length of an edge in the image
    Method method = Method::phong;
    double rmse = 0, largest = 0;  ///< of the intensity; 1 is the light's own
    /// The brightest highlight (intensity without ambient and diffuse parts is not told apart: all of it).
    double peak = 0, peak_of_sphere = 0;
    /// Mach bands: |I(x - 1) - 2 I(x) + I(x + 1)|, and down, where an edge of the mesh lies between these
    /// pixels, and where none does; 99 of 100 have no more. Where the sphere turns by no more than 45 degrees
    /// from the eye: farther out foreshortening bends every picture.
    double bend_at_edges = 0, bend_inside = 0;
};

/// The missed highlight, as geometry.
struct MissedHighlight {
    int level = 0;
    double nearest_degrees = 0;     ///< from the highlight's centre to the nearest corner's normal
    double half_width_degrees = 0;  ///< from the centre to where the highlight has half its strength
    double predicted_peak = 0;      ///< the brightest corner that is seen: interpolation exceeds no corner
    double measured_peak = 0;       ///< of the Gouraud picture
    double sphere_peak = 0;         ///< of the sphere itself
};

/// A level's pictures for those who look.
struct LevelPicture {
    int level = 0;
    Method method = Method::phong;
    Plane<double> intensity, difference;  ///< difference: of the sphere, absolute; NaN beside it
    Plane<float> bend;                    ///< as bend_at_edges, every pixel
};

struct TessellationStudy {
    std::vector<LevelScore> scores;
    std::vector<MissedHighlight> missed;
    std::vector<LevelPicture> pictures;
};

TessellationStudy study_tessellation(const Lighting& lighting, int most_levels, int side_px);

/// |second difference|, the larger of across and down; NaN where a neighbour shows nothing.
Plane<float> bends(const Plane<double>& intensity);

}  // namespace zproof::study::shading
