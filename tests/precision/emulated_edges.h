/// Which pixels a piece of a triangle covers, and with which weights of its corners.
#pragma once

#include <array>
#include <optional>

#include "tests/precision/emulated_vertices.h"

namespace zproof {

using Weights = std::array<double, 3>;

/// A corner in the window.
struct WindowPoint {
    double x = 0, y = 0;                  ///< px, as the transform has it
    double x_snapped = 0, y_snapped = 0;  ///< px, on the grid; the same where nothing snaps
};
using WindowPiece = std::array<WindowPoint, 3>;
WindowPoint window_point(const View& view, const RasterPrecision& precision, const EmulatedCorner& corner);

/// Edge functions of corners in the window, exact or from a corner.
class EmulatedEdges {
  public:
    EmulatedEdges(const RasterPrecision& precision, const WindowPiece& piece);
    bool is_drawn() const { return is_drawn_; }
    /// The weights at a pixel's centre, where it is covered.
    std::optional<Weights> weights_at(const glm::dvec2& p_raster) const;

  private:
    std::optional<Weights> exact_at(const glm::dvec2& p_raster) const;
    template <class T>
    std::optional<Weights> rounded_at(const glm::dvec2& p_raster) const;
    template <class T>
    T edge(const WindowPoint& from, const WindowPoint& to, double x, double y) const;

    RasterPrecision precision_;
    WindowPiece piece_;
    double area_ = 0;  ///< twice it, with its sign
    bool is_drawn_ = false;
};

/// Edge functions of corners before the divide (Olano and Greer 1997): nothing is clipped.
class HomogeneousEdges {
  public:
    HomogeneousEdges(const RasterPrecision& precision, const View& view,
                     const std::array<EmulatedCorner, 3>& corners);
    bool is_drawn() const { return determinant_ != 0; }
    /// The camera depth at a pixel's centre, where it is covered between near and far.
    std::optional<float> depth_at(const glm::dvec2& p_raster) const;
    struct Box {
        glm::dvec2 low, high;
    };
    /// The corners' box in the window; none where a corner is not in front of the eye.
    std::optional<Box> box_px() const;

  private:
    template <class T>
    void set_up();
    template <class T>
    std::optional<float> rounded_depth_at(const glm::dvec2& p_raster) const;

    Arithmetic arithmetic_;
    View view_;
    std::array<EmulatedCorner, 3> corners_;
    std::array<glm::dvec3, 3> normals_;
    double determinant_ = 0;
};

}  // namespace zproof
