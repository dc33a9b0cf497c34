/// Most answers that are asked about are seen at their pixel's centre or right next to it. To say so takes
/// nobody's bounds (docs/truth.md, "At a glance").
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compare/hearing/square_places.h"
#include "compare/search/acquaintance.h"

namespace zproof {

/// Looks at the pixels of one tile after the other, in double precision.
class Glance {
  public:
    explicit Glance(Acquaintance& acquaintance) : acquaintance_(acquaintance) {}

    /// Turns to another tile: `near` holds every triangle that comes within twice aside_px of any pixel that
    /// will be asked about. What is known of triangles must not be forgotten until it turns to the next.
    void turn_to(std::span<const std::uint32_t> near, double aside_px);
    /// Is the answer seen at one place, which is the pixel's centre or at most aside_px from it in x and in y:
    /// does nothing hide it there, whatever the rule, certainly?
    bool sees(PrimitiveId answer, const PixelPlace& pixel) const;

  private:
    /// A place of the image, in pixels.
    struct Place {
        double x, y;
    };

    Place likely_place(const TriangleFilter& answer, const Place& centre) const;
    bool is_bare(const Place& at) const;
    bool is_seen(std::size_t answer, const Place& at) const;
    bool is_behind(std::size_t back, std::size_t front, const Place& at) const;

    Acquaintance& acquaintance_;
    double aside_px_ = 0;
    std::span<const std::uint32_t> near_;
    std::vector<const TriangleFilter*> filters_;  ///< of near_
    SquarePlaces points_;                         ///< of near_, in squares without extent
};

}  // namespace zproof
