/// Pixels that are wrong for certain, by as little as is wanted: the rationals say by how much.
#pragma once

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
    /// Depths may err by a share of `depth_relative`. Where pieces of a triangle that is cut move apart, a
    /// gap may open along any of its diagonals.
    WrongPlaces(const Trial& trial, double depth_relative, Sharing sharing);

    /// Least displacements needed, of all pixels, in order.
    std::vector<double> needs() const;

    /// At each pixel the answer that needs least of those which need more than factor x eps_px. Pixels that
    /// have none show the truth.
    PlantedFrame planted(double eps_px, double factor) const;

  private:
    void find(int x, int y);
    bool hides(std::size_t occluder, std::size_t hidden, const ExactPlace& p, double half_side) const;
    template <class N>
    N held_within(const Image<N>& image, const Place<N>& p) const;
    std::optional<double> exact_factor(const WrongPlace& wrong, int x, int y, double eps_px) const;

    const Trial& trial_;
    double depth_relative_;
    Sharing sharing_;
    Plane<std::vector<WrongPlace>> at_;
};

/// What of a triangle's plane counts for its depth at a pixel.
enum class DepthFrom {
    square,    ///< all of the square, as docs/bounds.md has it
    own_part,  ///< only the triangle's own part of it: no displaced triangle has depths beyond
};

/// A frame whose ids are true, and whose depths lie beyond what the promise permits by `factor`, on either
/// side. Triangles may be displaced by the promise's eps.
PlantedFrame with_wrong_depths(const Trial& trial, const BoundedPrecision& promise, DepthFrom from,
                               double factor);

}  // namespace zproof::attack
