/// Queries about the pixels of one tile, decided one after the other among the triangles that come near it.
#pragma once

#include <array>
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
    /// Otherwise the reach that it needs. Queries about one pixel should follow each other.
    double decide(const PixelQuery& query, double searched_px, QueryResult& adjudicated);
    /// The triangles whose image's box comes within reach_px of the pixel's centre by the bounds, ascending.
    std::vector<std::uint32_t> triangles_within(double reach_px, const PixelCoord& pixel,
                                                const ViewBounds& bounds);

  private:
    /// A triangle near the pixel at hand.
    struct NearTriangle {
        std::size_t place;   ///< in the cache
        double distance_px;  ///< of its image's box from the centre
        Neighbour neighbour;
    };
    /// The answer that was first asked about a square of the image, and whether it is truly there all over
    /// it.
    struct Filling {
        PrimitiveId answer;
        bool is_true;
    };
    static constexpr int block_px = 4, blocks_in_a_row = Tiles::side_px / block_px;

    bool is_there_truly(const PixelQuery& query);
    bool is_true_all_over(const PixelQuery& query, int side_px);
    const Neighbour& seen_in_tile(std::size_t place, const PixelQuery& query);
    void look_at(const PixelQuery& query, double reach_px);
    double own_eps_px(const PixelQuery& query) const;
    double eps_px_within(double reach_px, double own_eps_px) const;
    /// Are more triangles near than are looked at?
    bool has_too_many_within(const PixelQuery& query, double reach_px);
    void gather(double reach_px);
    void add_answer(const PixelQuery& query);
    double farthest_depth(const PixelQuery& query, Admissibility admissibility);
    void decide_around(const PixelQuery& query, QueryResult& adjudicated);
    bool reaches_a_side() const;

    const Setting& setting_;
    TriangleCache triangles_;
    PixelCoord pixel_{-1, -1};
    double seen_px_ = 0;  ///< so far
    std::vector<NearTriangle> seen_;
    Neighbourhood around_;  ///< of the query at hand
    std::array<std::optional<Filling>, 1 + blocks_in_a_row * blocks_in_a_row> fillings_;  ///< tile, blocks
    std::vector<std::unique_ptr<Neighbour>> seen_in_tile_;  ///< by place; of queries for any reason
    std::size_t work_left_, displacement_work_left_;
};

}  // namespace zproof
