/// Pixels that are wrong for certain, by as little as is wanted: the rationals say by how much.
#pragma once

#include <span>

#include "compare/pixel_class.h"
#include "tests/attack/trial.h"

namespace zproof::attack {

/// One answer that no renderer with this promise may give.
struct PlantedPixel {
    int x = 0, y = 0;
    PixelClass kind = PixelClass::hole;  ///< in which way it is wrong
    double factor = 0;                   ///< what it would need, as a multiple of the promise
};

struct PlantedFrame {
    Frame frame;
    std::vector<PlantedPixel> pixels;
};

/// How far triangles would have to be displaced until an honest renderer might answer so.
struct WrongPlace {
    PixelClass kind = PixelClass::hole;
    PrimitiveId primitive = PrimitiveId::none;
    std::size_t other = 0;  ///< the triangle that covers the pixel, or hides the answer
    double need_px = 0;
};

/// A frame's worth of answers that need more displacement than some promise, by pixels.
class WrongPlaces {
  public:
    /// Depths may err by a share of `depth_relative`, and a plane counts all over the square. Where pieces of
    /// a triangle that is cut move apart, a gap may open along any of its diagonals. These end where near and
    /// far cut, which err as depths do.
    WrongPlaces(const Trial& trial, double depth_relative, Sharing sharing);

    /// Least displacements needed, of all pixels, in order.
    std::vector<double> needs() const;

    /// At each pixel the answer that needs least of those which need more than factor x eps_px. Pixels that
    /// have none show the truth.
    PlantedFrame planted(double eps_px, double factor) const;

    /// The same for a frame of labels: all triangles of one need more. The frame still names a triangle of
    /// the label, at a depth that this one has.
    PlantedFrame planted_labels(std::span<const std::uint32_t> label_of_triangle, double eps_px,
                                double factor) const;

  private:
    void find(int x, int y);
    const WrongPlace* least_of_label(std::span<const std::uint32_t> label_of_triangle, std::uint32_t label,
                                     int x, int y) const;
    void show(PlantedFrame& planted, const WrongPlace& wrong, int x, int y, double eps_px,
              double factor) const;
    bool hides(std::size_t occluder, std::size_t hidden, const ExactPlace& p, double half_side) const;
    Number held_within(std::size_t triangle, const ExactPlace& p) const;
    double roughly_held(std::size_t triangle, int x, int y) const;
    std::optional<double> exact_factor(const WrongPlace& wrong, int x, int y, double eps_px) const;

    const Trial& trial_;
    double depth_relative_;
    Sharing sharing_;
    /// How far what is left of a triangle moves with near and far, where they err as depths may. None: it may
    /// have more corners then, or fewer.
    std::vector<std::optional<Number>> moved_by_planes_px_;
    Plane<std::vector<WrongPlace>> at_;
    Plane<std::vector<std::uint32_t>> may_be_shown_;  ///< triangles that cover the centre, and are not hidden
};

}  // namespace zproof::attack
