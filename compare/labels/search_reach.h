/// How far around a pixel triangles must be looked for, so that none is missed that is admissible there.
#pragma once

#include <array>
#include <vector>

#include "compare/adjudicate/image_box.h"
#include "compare/adjudicate/tiles.h"
#include "compare/bounds/pixel_coord.h"
#include "math/affine.h"
#include "scenes/scene.h"

namespace zproof {

class SearchReach {
  public:
    /// Looks at every triangle once; on all threads. All must outlive it.
    SearchReach(const Scene& scene, const View& view, const ViewBounds& bounds);

    /// A triangle farther than this from the pixel's centre meets no square that an answer there is judged
    /// in.
    double at(const PixelCoord& pixel) const;
    /// Triangles that may lie farther, ascending: rounded edges may all say that they hold the pixel's
    /// centre.
    std::vector<std::uint32_t> shown_by_rounding(const PixelCoord& pixel) const;

  private:
    /// A triangle that rounding may show far beyond its corners. It does so only where all its edges, or all
    /// of them turned round, are no less than minus the margin.
    struct Thin {
        std::uint32_t triangle;
        std::array<Affine<double>, 3> edges;  ///< of pixel indices
        std::array<double, 3> margins;

        bool may_show(const PixelCoord& pixel) const;
        Box box() const;  ///< around all pixels at which it may be shown
    };
    /// A triangle that may reach farther than `least_px`.
    struct Wide {
        std::uint32_t triangle;
        double most_px;  ///< its largest eps anywhere
        Box box;         ///< around its image
    };

    const Scene& scene_;
    const View& view_;
    const ViewBounds& bounds_;
    std::vector<Wide> wide_;  ///< the largest eps first
    std::vector<Thin> thin_;
    Tiles tiles_;
    std::vector<std::vector<std::uint32_t>> thin_by_tile_;  ///< places in thin_, by tile
    std::vector<std::uint32_t> thin_anywhere_;              ///< those of no box

    Thin thin_of(std::uint32_t triangle) const;
    void sort_by_tile();
};

}  // namespace zproof
