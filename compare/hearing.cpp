#include "compare/hearing.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "compare/displacement.h"
#include "compare/summary.h"
#include "compare/tile_search.h"

namespace zproof {

namespace {

/// In own eps. Few squares grow beyond it, and a triangle that is found and meets no square changes nothing.
constexpr double first_reach = 2;

/// The triangles of the latest answers: neighbouring pixels give the same.
class LatestTriangles {
  public:
    const TriangleOfView& of(Acquaintance& acquaintance, std::uint32_t triangle, const ViewBounds& bounds) {
        const std::size_t mixed = triangle ^ std::hash<const ViewBounds*>{}(&bounds) >> 6;
        Latest& latest = latest_[mixed % latest_.size()];
        if (latest.bounds != &bounds || latest.triangle != triangle)
            latest = {triangle, &bounds, &acquaintance.of(triangle, bounds).of_view};
        return *latest.found;
    }

  private:
    struct Latest {
        std::uint32_t triangle = 0;
        const ViewBounds* bounds = nullptr;
        const TriangleOfView* found = nullptr;
    };
    std::array<Latest, 16> latest_;
};

}  // namespace

struct Hearing::Memories {
    Memories(const Scene& scene, const View& view) : acquaintance(scene, view) {}

    Acquaintance acquaintance;
    CoplanarMemory coplanar{4096};
};

/// Pleas stand by tile.
class Hearing::Session {
  public:
    Session(const Hearing& hearing, Asked asked, tbb::enumerable_thread_specific<Memories>& memories)
        : hearing_(hearing),
          pleas_(hearing.pleas_),
          asked_(asked),
          memories_(memories),
          sights_(hearing.view_),
          tiles_(hearing.view_),
          first_(tiles_.count() + 1),
          near_(hearing.scene_, hearing.view_, asked_boxes()) {}

    /// Decides what it can; for each plea the reach that it needs, or 0 where it is decided.
    std::vector<double> hear(std::vector<Ruled>& rulings) {
        std::vector<double> lacking(pleas_.size(), 0);
        tbb::parallel_for(std::size_t(0), tiles_.count(), [&](std::size_t tile) {
            if (first_[tile] != first_[tile + 1]) hear_tile(tile, rulings, lacking);
        });
        return lacking;
    }

  private:
    AskedBoxes asked_boxes() {
        AskedBoxes boxes(tiles_.count());
        for (const Plea& plea : pleas_) {
            const std::size_t tile = tiles_.of(plea.x, plea.y);
            boxes.add(tile, square_around(plea.x, plea.y, plea.reach_px), plea.reach_px);
            ++first_[tile + 1];
        }
        for (std::size_t t = 1; t < first_.size(); ++t) first_[t] += first_[t - 1];
        return boxes;
    }
    Around centres(std::span<const Plea> pleas) const {
        Box box;
        for (const Plea& plea : pleas) box.add(plea.x, plea.y);
        return {box.middle_x(), box.middle_y(), 0.5 * (box.right - box.left), 0.5 * (box.bottom - box.top)};
    }

    void hear_tile(std::size_t tile, std::vector<Ruled>& rulings, std::vector<double>& lacking) const {
        const std::span<const Plea> pleas =
            std::span(pleas_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
        Memories& memories = memories_.local();
        std::vector<const ViewBounds*> renderers;
        for (const Plea& plea : pleas)
            if (!std::ranges::count(renderers, plea.bounds)) renderers.push_back(plea.bounds);
        std::optional<Summary> summary;
        if (!hearing_.amendment_)
            summary.emplace(
                Summary::Shared{hearing_.view_, sights_, memories.acquaintance, memories.coplanar},
                centres(pleas), near_.of(tile), renderers);
        const Plea* latest = nullptr;
        for (const Plea& plea : pleas) {
            if (summary && !(latest && latest->x == plea.x && latest->y == plea.y))
                summary->look_at(plea.x, plea.y);
            latest = &plea;
            const Plaint plaint{plea.bounds, plea.answer, plea.own_eps_px, plea.reach_px, asked_};
            double& lacks = lacking[std::size_t(&plea - pleas_.data())];
            if (const auto ruled = summary ? summary->rule(plaint) : std::nullopt)
                rulings[plea.number] = *ruled;
            else if (!summary || (lacks = summary->lacking_reach_px(plaint)) == 0)
                lacks = try_to_hear(plea, near_.of(tile), memories, rulings[plea.number]);
        }
    }

    /// Decides the plea, or returns the reach that it needs.
    double try_to_hear(const Plea& plea, std::span<const std::uint32_t> near, Memories& memories,
                       Ruled& ruled) const {
        Site site{plea.x, plea.y, plea.reach_px, {}};
        for (const std::uint32_t t : near)
            if (memories.acquaintance.of(t).filter.is_near(plea.x, plea.y, plea.reach_px))
                site.triangles.push_back(t);
        Neighbourhood around = neighbourhood_of(hearing_.view_, site, plea.own_eps_px,
                                                [&](std::uint32_t t) -> const TriangleOfView& {
                                                    return memories.acquaintance.of(t, *plea.bounds).of_view;
                                                });
        if (around.eps_px > plea.reach_px) return around.eps_px;
        if (hearing_.amendment_) hearing_.amendment_(around, plea.answer);
        ruled = {decide(around, plea.answer, memories.coplanar), around.eps_px, std::nullopt};
        if (asked_ == Asked::standing_and_displacement && ruled.decision.standing == Standing::visible)
            ruled.displacement_over_eps = displacement_over_eps(around, plea.answer);
        return 0;
    }

    const Hearing& hearing_;
    std::span<const Plea> pleas_;
    Asked asked_;
    tbb::enumerable_thread_specific<Memories>& memories_;
    Sights<double> sights_;
    Tiles tiles_;
    std::vector<std::size_t> first_;  ///< plea of a tile
    TrianglesByTile near_;
};

void Hearing::add(const ViewBounds& bounds, PrimitiveId answer, int x, int y) {
    pleas_.push_back({&bounds, answer, x, y, 0, 0, pleas_.size()});
}

/// The squares that grow beyond their first reach are looked at once more with their full reach.
std::vector<Ruled> Hearing::hear(Asked asked) {
    std::vector<Ruled> rulings(pleas_.size());
    tbb::enumerable_thread_specific<Memories> memories([&] { return Memories(scene_, view_); });
    const Sights<double> sights(view_);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pleas_.size(), 256), [&](const auto& some) {
        Acquaintance& acquaintance = memories.local().acquaintance;
        LatestTriangles latest;
        for (std::size_t i = some.begin(); i < some.end(); ++i) {
            Plea& plea = pleas_[i];
            plea.own_eps_px = plea.answer == PrimitiveId::none
                                  ? plea.bounds->background_eps_px()
                                  : latest.of(acquaintance, std::uint32_t(plea.answer), *plea.bounds)
                                        .eps_px(sights.at(plea.x, plea.y));
            plea.reach_px = first_reach * plea.own_eps_px;
        }
    });
    sort_by_tile();
    while (!pleas_.empty()) {
        const std::vector<double> lacking = Session(*this, asked, memories).hear(rulings);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < pleas_.size(); ++i) {
            if (lacking[i] == 0) continue;
            pleas_[kept] = pleas_[i];
            pleas_[kept++].reach_px = lacking[i];
        }
        pleas_.resize(kept);
    }
    return rulings;
}

void Hearing::sort_by_tile() {
    const Tiles tiles(view_);
    std::vector<std::size_t> next(tiles.count() + 1);
    for (const Plea& plea : pleas_) ++next[tiles.of(plea.x, plea.y) + 1];
    for (std::size_t t = 1; t < next.size(); ++t) next[t] += next[t - 1];
    std::vector<Plea> sorted(pleas_.size());
    for (const Plea& plea : pleas_) sorted[next[tiles.of(plea.x, plea.y)]++] = plea;
    pleas_ = std::move(sorted);
}

}  // namespace zproof
