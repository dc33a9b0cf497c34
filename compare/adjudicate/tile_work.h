/// Queries about the pixels of one tile, decided one after the other among the triangles that come near it.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compare/adjudicate/pixel_query.h"
#include "compare/adjudicate/tiles.h"
#include "compare/adjudicate/triangle_cache.h"
#include "compare/bounds/view_ray.h"

namespace zproof {

class TileWork {
  public:
    struct Setting {
        const Scene& scene;
        const View& view;
        const ViewRays<double>& rays;
        const TriangleSearch& search;
        QueryDetail asked;
        const RuleOverride& override;
    };
    /// `near`: all triangles within the reach that will be asked for of any pixel that is. `most_work`, in
    /// cuts of a region by a half-plane, may be spent on all queries together, and as much on displacements;
    /// what is asked after that is undecidable.
    TileWork(const Setting& setting, std::span<const std::uint32_t> near,
             std::size_t most_work = std::numeric_limits<std::size_t>::max());

    /// Decides the query, where no triangle farther than searched_px from its centre can matter, and says 0.
    /// Otherwise the reach that it needs.
    double decide(const PixelQuery& query, double searched_px, QueryResult& adjudicated);
    /// The triangles whose image's box comes within reach_px of the pixel's centre by the bounds, ascending.
    std::vector<std::uint32_t> triangles_within(double reach_px, const PixelCoord& pixel,
                                                const ViewBounds& bounds);

  private:
    /// A triangle's place in the cache, and how far its image's box lies from a pixel's centre.
    struct NearPlace {
        std::size_t place;
        double distance_px;
    };
    struct NearTriangle {
        double distance_px;
        Neighbour neighbour;
    };

    bool is_there_truly(const PixelQuery& query);
    const Neighbour& seen_in_tile(std::size_t place, const PixelQuery& query);
    std::vector<NearPlace> places_within(double reach_px, const PixelCoord& pixel, const ViewBounds& bounds);
    void look_at(const PixelQuery& query, std::span<const NearPlace> places);
    double own_eps_px(const PixelQuery& query) const;
    double eps_px_within(double reach_px, double own_eps_px) const;
    void gather(const PixelQuery& query, double reach_px);
    void add_answer(const PixelQuery& query);
    double farthest_depth(const PixelQuery& query, Admissibility admissibility);
    void decide_around(const PixelQuery& query, QueryResult& adjudicated);
    bool reaches_a_side() const;

    const Setting& setting_;
    TriangleCache triangles_;
    std::vector<NearTriangle> seen_;                        ///< of the query at hand
    Neighbourhood around_;                                  ///< of the query at hand
    std::vector<std::unique_ptr<Neighbour>> seen_in_tile_;  ///< by place; of queries for any reason
    std::size_t work_left_, displacement_work_left_;
};

}  // namespace zproof
