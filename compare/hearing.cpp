#include "compare/hearing.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "compare/displacement.h"
#include "compare/summary.h"
#include "compare/tile_search.h"

namespace zproof {

namespace {

/// In own eps. Few squares grow beyond it, and a triangle that is found and meets no square changes nothing.
constexpr double first_reach = 2;

/// Triangles are looked for at least that far, so that squares which grow a little need no other search: that
/// costs more than the few triangles which are found for nothing.
constexpr double least_search_px = 1.0 / 12;

/// Of so many sittings that many pleas, the first, are asked whether that is far enough.
constexpr std::size_t sittings_sampled = 32;
constexpr std::uint32_t pleas_sampled = 2;

/// Tiles that lie close together follow each other: they have triangles in common.
template <class Visit>
void for_each_by_blocks(const Tiles& tiles, const Visit& visit) {
    constexpr int side = 8;
    for (int top = 0; top < tiles.rows; top += side)
        for (int left = 0; left < tiles.columns; left += side)
            for (int row = top; row < std::min(top + side, tiles.rows); ++row)
                for (int column = left; column < std::min(left + side, tiles.columns); ++column)
                    visit(tiles.index(column, row));
}

/// On all threads. Some take a thousand times as long as others: each is shared out by itself.
template <class Item, class Do>
void for_each_of(const std::vector<Item>& items, const Do& act) {
    tbb::parallel_for(
        std::size_t(0), items.size(), [&](std::size_t i) { act(items[i]); }, tbb::simple_partitioner());
}

}  // namespace

struct Hearing::Memories {
    Memories(const Scene& scene, const View& view)
        : sights(view), acquaintance(scene, view), summary({view, sights, acquaintance, coplanar}) {}
    Memories(const Memories&) = delete;  // what is summed up looks at the rest
    Memories& operator=(const Memories&) = delete;

    double first_reach_px(const Plea& plea) { return first_reach * own_eps_px(plea); }
    double own_eps_px(const Plea& plea) {
        if (plea.answer == PrimitiveId::none) return plea.bounds->background_eps_px();
        const BoundedTriangle& triangle = acquaintance.of(std::uint32_t(plea.answer), *plea.bounds);
        return triangle.of_view.eps_px(sights.at(plea.x, plea.y));
    }

    Sights<double> sights;
    Acquaintance acquaintance;
    CoplanarMemory coplanar{4096};
    Summary summary;
};

class Hearing::Session {
  public:
    Session(const Hearing& hearing, const Docket& docket, Asked asked, ThreadMemories& memories)
        : hearing_(hearing),
          docket_(docket),
          asked_(asked),
          memories_(memories),
          near_(hearing.scene_, hearing.view_, asked_tiles()) {}

    /// Decides what it can; for each plea of the docket the reach that it needs, or 0 where it is decided.
    std::vector<double> hear(std::vector<Ruled>& rulings) {
        std::vector<double> lacking(docket_.plea.size(), 0);
        for_each_of(docket_.sittings, [&](const Sitting& s) { hear_sitting(s, rulings, lacking); });
        return lacking;
    }

  private:
    const Plea& plea(std::size_t place) const { return hearing_.pleas_[docket_.plea[place]]; }

    double searched_px(std::size_t place) const { return std::max(docket_.reach_px[place], least_search_px); }

    AskedTiles asked_tiles() const {
        const Tiles tiles(hearing_.view_);
        std::vector<std::uint32_t> pleas_of_tile(tiles.count());
        for (const Sitting& sitting : docket_.sittings)
            pleas_of_tile[sitting.tile] = sitting.end - sitting.first;
        AskedTiles asked(tiles, pleas_of_tile);
        for_each_of(docket_.sittings, [&](const Sitting& sitting) { add_squares(sitting, asked); });
        return asked;
    }
    /// One for all pleas at a pixel that follow each other.
    void add_squares(const Sitting& sitting, AskedTiles& asked) const {
        for (std::size_t i = sitting.first; i < sitting.end;) {
            const Plea& at = plea(i);
            double reach_px = 0;
            for (; i < sitting.end && plea(i).x == at.x && plea(i).y == at.y; ++i)
                reach_px = std::max(reach_px, searched_px(i));
            asked.add(sitting.tile, square_around(at.x, at.y, reach_px), reach_px);
        }
    }
    Around centres(const Sitting& sitting) const {
        Box box;
        for (std::size_t i = sitting.first; i < sitting.end; ++i) box.add(plea(i).x, plea(i).y);
        return {box.middle_x(), box.middle_y(), 0.5 * (box.right - box.left), 0.5 * (box.bottom - box.top)};
    }

    std::vector<const ViewBounds*> renderers_of(const Sitting& sitting) const {
        std::vector<const ViewBounds*> renderers;
        for (std::size_t i = sitting.first; i < sitting.end; ++i)
            if (!std::ranges::count(renderers, plea(i).bounds)) renderers.push_back(plea(i).bounds);
        return renderers;
    }

    void hear_sitting(const Sitting& sitting, std::vector<Ruled>& rulings,
                      std::vector<double>& lacking) const {
        const std::span near = near_.of(sitting.tile);
        Memories& memories = memories_.local();
        memories.acquaintance.forget_if_much();
        Summary* const summary = hearing_.amendment_ ? nullptr : &memories.summary;
        if (summary) summary->turn_to(centres(sitting), near, renderers_of(sitting));
        Plaint plaint;
        std::size_t i = sitting.first;
        const auto gather_here = [&] { return gather(plaint, i, near, memories); };
        Estimate estimate(std::ref(gather_here), memories.coplanar);
        const Plea* latest = nullptr;
        for (; i < sitting.end; ++i) {
            const Plea& p = plea(i);
            Ruled& ruled = rulings[docket_.plea[i]];
            if (summary && !(latest && latest->x == p.x && latest->y == p.y)) summary->look_at(p.x, p.y);
            latest = &p;
            const double own_eps_px = memories.own_eps_px(p);
            const double known_px = docket_.reach_px[i];
            const double reach_px = known_px != 0 ? known_px : first_reach * own_eps_px;
            plaint = {p.bounds, p.answer, own_eps_px, reach_px, asked_};
            if (reach_px > searched_px(i)) {  // its triangles are not all known
                lacking[i] = reach_px;
                continue;
            }
            estimate.turn_to(p.answer);
            const auto hear_at_reach = [&] {
                if (const auto known = summary ? summary->rule(plaint, estimate) : std::nullopt) {
                    ruled = *known;
                    return 0.0;
                }
                const double reach = summary ? summary->lacking_reach_px(plaint) : 0;
                return reach != 0 ? reach : try_to_hear(plaint, estimate, memories, ruled);
            };
            lacking[i] = hear_at_reach();
            while (lacking[i] != 0 && lacking[i] <= searched_px(i)) {
                plaint.reach_px = lacking[i];
                estimate.turn_to(p.answer);
                lacking[i] = hear_at_reach();
            }
        }
    }

    /// What stands around the plea, as far as the plaint's reach, as the law or the amendment has it.
    Neighbourhood gather(const Plaint& plaint, std::size_t place, std::span<const std::uint32_t> near,
                         Memories& memories) const {
        const Plea& p = plea(place);
        Site site{p.x, p.y, plaint.reach_px, {}};
        for (const std::uint32_t t : near)
            if (memories.acquaintance.of(t).filter.is_near(p.x, p.y, site.reach_px))
                site.triangles.push_back(t);
        const auto look_up = [&](std::uint32_t t) -> const TriangleOfView& {
            return memories.acquaintance.of(t, *p.bounds).of_view;
        };
        Neighbourhood around = neighbourhood_of(hearing_.view_, site, plaint.own_eps_px, look_up);
        if (hearing_.amendment_) hearing_.amendment_(around, p.answer);
        return around;
    }
    /// Decides the plea, or returns the reach that it needs.
    double try_to_hear(const Plaint& plaint, Estimate& estimate, Memories& memories, Ruled& ruled) const {
        const Neighbourhood& around = estimate.around();
        if (around.eps_px > plaint.reach_px) return around.eps_px;
        ruled = {decide(around, plaint.answer, memories.coplanar), around.eps_px, std::nullopt};
        if (asked_ == Asked::standing_and_displacement && ruled.decision.standing == Standing::visible)
            ruled.displacement_over_eps = displacement_over_eps(estimate);
        return 0;
    }

    const Hearing& hearing_;
    const Docket& docket_;
    Asked asked_;
    ThreadMemories& memories_;
    TrianglesByTile near_;
};

auto Hearing::docket_of_all() const -> Docket {
    const Tiles tiles(view_);
    // counted two places ahead, so that filling leaves each tile's end where the next one's first belongs
    std::vector<std::uint32_t> first(tiles.count() + 2);
    for (const Plea& plea : pleas_)
        if (plea.bounds) ++first[tiles.of(plea.x, plea.y) + 2];
    for (std::size_t t = 2; t < first.size(); ++t) first[t] += first[t - 1];
    const std::size_t count = first.back();
    Docket docket{std::vector<std::uint32_t>(count), std::vector<double>(count, 0), {}};
    for (std::uint32_t i = 0; i < pleas_.size(); ++i)
        if (const Plea& plea = pleas_[i]; plea.bounds) docket.plea[first[tiles.of(plea.x, plea.y) + 1]++] = i;
    for_each_by_blocks(tiles, [&](std::size_t t) {
        if (first[t] != first[t + 1]) docket.sittings.push_back({t, first[t], first[t + 1]});
    });
    return docket;
}

/// A sample says, of the pleas of both renderers: where it is wrong, that costs another search, or knowledge
/// of triangles that is made twice.
bool Hearing::may_reach_far(const Docket& docket, Memories& memories) const {
    const std::size_t stride = docket.sittings.size() / sittings_sampled + 1;
    for (std::size_t s = 0; s < docket.sittings.size(); s += stride) {
        const auto [tile, first, end] = docket.sittings[s];
        for (std::size_t i = first; i < std::min(end, first + pleas_sampled); ++i)
            if (memories.first_reach_px(pleas_[docket.plea[i]]) > least_search_px) return true;
    }
    return false;
}

void Hearing::set_reach(Docket& docket, const Sitting& sitting, Memories& memories) const {
    memories.acquaintance.forget_if_much();
    for (std::size_t i = sitting.first; i < sitting.end; ++i)
        docket.reach_px[i] = memories.first_reach_px(pleas_[docket.plea[i]]);
}

auto Hearing::left_over(const Docket& docket, const std::vector<double>& lacking) const -> Docket {
    Docket left;
    for (const Sitting& sitting : docket.sittings) {
        const auto first = std::uint32_t(left.plea.size());
        for (std::size_t i = sitting.first; i < sitting.end; ++i) {
            if (lacking[i] == 0) continue;
            left.plea.push_back(docket.plea[i]);
            left.reach_px.push_back(lacking[i]);
        }
        const auto end = std::uint32_t(left.plea.size());
        if (first != end) left.sittings.push_back({sitting.tile, first, end});
    }
    return left;
}

/// The squares that grow beyond their first reach are looked at once more with their full reach.
std::vector<Ruled> Hearing::hear(std::vector<Plea> pleas, Asked asked) {
    pleas_ = std::move(pleas);
    std::vector<Ruled> rulings(pleas_.size());
    ThreadMemories memories([&] { return Memories(scene_, view_); });
    Docket docket = docket_of_all();
    if (may_reach_far(docket, memories.local()))
        for_each_of(docket.sittings, [&](const Sitting& s) { set_reach(docket, s, memories.local()); });
    while (!docket.plea.empty())
        docket = left_over(docket, Session(*this, docket, asked, memories).hear(rulings));
    return rulings;
}

}  // namespace zproof
