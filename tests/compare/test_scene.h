/// Scenes and frames made by hand: corners in pixels of the image, answers pixel by pixel.
#pragma once

#include <array>
#include <vector>

#include "compare/admissible/neighbourhood.h"
#include "compare/judge.h"

namespace zproof {

/// A corner that is seen at a raster position (x right, y down, px) at a camera depth. Exact in float32 where
/// the position is, and the depth is a power of two or the view parallel.
struct Corner {
    double x, y, depth;
};
using Triangle = std::array<Corner, 3>;

/// One unit of the image plane is one pixel; near 1/4, far 1024 (perspective) or 64 (parallel).
View pixel_view(Projection projection, int width, int height);

/// Triangles in order, each with corners of its own: they share an edge where positions are equal.
Scene scene_of(const View& view, const std::vector<Triangle>& triangles);

/// Covers every image of up to 16 x 16 pixels by far, at one depth.
Triangle wall(double depth);
/// Covers such an image's part left (right) of x; its edge there runs from row `top` to row `bottom`.
Triangle wall_left_of(double x, double depth, double top = -64, double bottom = 64);
Triangle wall_right_of(double x, double depth, double top = -64, double bottom = 64);

/// x is y, and the other way round.
Triangle transposed(Triangle triangle);

/// A rasterizer with 8 sub-pixel bits and a float64 transform, and a float32 ray caster.
Precision raster_precision();
Precision ray_precision();

void answer(Frame& frame, int x, int y, std::uint32_t triangle, double depth);
void answer_background(Frame& frame, int x, int y);
/// Every pixel gives the same answer.
void answer_everywhere(Frame& frame, std::uint32_t triangle, double depth);

/// A scene, two frames (all background until told otherwise) and their judge.
struct TestScene {
    View view;
    Scene scene;
    Frame candidate, reference;
    Precision candidate_precision = raster_precision(), reference_precision = ray_precision();

    TestScene(Projection projection, int width, int height, const std::vector<Triangle>& triangles);

    Verdict verdict() const {
        return judge(scene, view, {candidate, candidate_precision}, {reference, reference_precision},
                     full_detail);
    }
    PixelClass class_at(int x, int y) const { return verdict().classes.at(x, y); }
    /// Half-side of the square in which the candidate's answer (triangle) would be judged.
    double candidate_eps_px(int x, int y, std::uint32_t triangle) const;
};

}  // namespace zproof
