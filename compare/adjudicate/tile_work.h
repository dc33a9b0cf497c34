/// The queries of one tile, decided one after the other among the triangles that come near it.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "compare/adjudicate/adjudicator.h"
#include "compare/adjudicate/triangle_search.h"
#include "compare/bounds/sight.h"

namespace zproof {

/// The triangles that come near a tile, each by the bounds of every renderer that is asked about; made when first asked
/// for.
class TriangleCache {
  public:
    TriangleCache(const Scene& scene, std::span<const std::uint32_t> near) : scene_(scene), near_(near) {}

    std::size_t count() const { return near_.size(); }
    std::uint32_t triangle(std::size_t place) const { return near_[place]; }
    /// Nothing where the triangle does not come near.
    std::optional<std::size_t> place_of(PrimitiveId triangle) const;
    const BoundedTriangle& of(std::size_t place, const ViewBounds& bounds);

  private:
    struct OfRenderer {
        const ViewBounds* bounds;
        std::vector<std::optional<BoundedTriangle>> triangles;  ///< by place
    };

    const Scene& scene_;
    std::span<const std::uint32_t> near_;  ///< ascending
    std::vector<OfRenderer> renderers_;    ///< a few
};

class TileWork {
  public:
    struct Setting {
        const Scene& scene;
        const Sights<double>& rays;
        const View& view;
        const TriangleSearch& search;
        Asked asked;
        const RuleOverride& override;
    };
    /// `near`: all triangles within searched_px of any pixel of the tile that is asked about.
    TileWork(const Setting& setting, std::span<const std::uint32_t> near);

    /// Decides the query, where no triangle farther than searched_px from its centre can matter, and says 0. Otherwise
    /// the reach that it needs.
    double decide(const PixelQuery& query, double searched_px, Adjudicated& adjudicated);

  private:
    void gather(const PixelQuery& query, double reach_px);
    double own_eps_px(const PixelQuery& query) const;
    double eps_px_within(double reach_px, double own_eps_px) const;
    void drop_beyond(double reach_px);

    const Setting& setting_;
    TriangleCache triangles_;
    std::vector<Box> boxes_;  ///< of the triangles' images
    CoplanarMemory coplanar_;
    Neighbourhood around_;              ///< of the query at hand
    std::vector<double> distances_px_;  ///< of its neighbours' boxes from the pixel's centre
};

}  // namespace zproof
