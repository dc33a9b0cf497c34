/// Most answers that are asked about are seen at their pixel's centre or right next to it. To say so takes
/// nobody's bounds (docs/truth.md, "At a glance").
#pragma once

#include "compare/hearing/filters_of_eight.h"
#include "compare/pixel_place.h"
#include "frame/frame.h"

namespace zproof {

/// Looks at the pixels of one tile after the other, in double precision.
class Glance {
  public:
    Glance(const Scene& scene, const View& view);

    /// Turns to another tile: `near` holds every triangle that comes within twice aside_px of any pixel that
    /// will be asked about.
    void turn_to(std::span<const std::uint32_t> near, double aside_px);
    /// Is the answer seen at one place, which is the pixel's centre or at most aside_px from it in x and in
    /// y: does nothing hide it there, whatever the rule, certainly?
    bool sees(PrimitiveId answer, const PixelPlace& pixel);

  private:
    /// A place of the image, in pixels.
    struct Place {
        double x, y;
    };

    Place likely_place(std::size_t answer, const Place& centre) const;
    std::span<const strips::PlacesOfEight> who_is_at(const Place& at);
    bool is_bare(const Place& at);
    bool is_seen(std::size_t answer, const Place& at);
    bool is_behind(std::size_t back, std::size_t front, const Place& at) const;

    FiltersByEights filters_;
    const strips::Kernel& kernel_;
    double aside_px_ = 0;
    std::span<const std::uint32_t> near_;
    std::vector<FiltersOfEight> eights_;  ///< of near_
    std::vector<strips::PlacesOfEight> places_;
};

}  // namespace zproof
