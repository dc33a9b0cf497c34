#include "compare/hearing/hearing.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "compare/hearing/glance.h"
#include "compare/hearing/summary.h"
#include "compare/search/between_planes.h"
#include "compare/search/tile_search.h"
#include "compare/truth/displacement.h"

namespace zproof {

namespace {

/// In own eps. Few squares grow beyond it, and a triangle that is found and meets no square changes nothing.
constexpr double first_reach = 2;

/// Triangles are looked for so many times as far as pleas are likely to reach, so that squares which grow
/// need no other search: that costs more than the few triangles which are found for nothing. No farther than
/// that, where pleas do not ask for it: of a mesh near the horizon a pixel holds thousands.
constexpr double searched_over_reach = 8, most_searched_px = 1.0 / 12;

/// For so many vertices of the scene, or triangles near, a plea by itself is less trouble than a look at
/// them.
constexpr std::size_t vertices_per_plea = 16, triangles_per_plea = 8;

/// So many answers of a tile may be missed before one is seen at a glance.
constexpr std::size_t missed_at_first = 2;

/// So many pleas are put in order by one thread.
constexpr std::size_t pleas_sorted = 2048;

/// Of so many sittings that many pleas, the first, say how far pleas reach.
constexpr std::size_t sittings_sampled = 32;
constexpr std::uint32_t pleas_sampled = 2;

constexpr Ruled seen_at_a_glance{.decision = {.standing = Standing::visible, .exact = false},
                                 .eps_px = std::numeric_limits<double>::quiet_NaN(),
                                 .displacement_over_eps = std::nullopt};

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
        : sights(view),
          acquaintance(scene, view),
          glance(scene, view),
          summary({view, sights, acquaintance, coplanar}) {}
    Memories(const Memories&) = delete;  // what comes last looks at the rest
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
    Glance glance;
    Summary summary;
};

class Hearing::Session {
  public:
    struct Question {
        Asked asked;
        bool at_a_glance;        ///< is what is seen at a glance an answer to it?
        double least_search_px;  ///< triangles are looked for so far around every pixel, or farther
    };
    Session(const Hearing& hearing, const Docket& docket, const Question& question, ThreadMemories& memories)
        : hearing_(hearing),
          docket_(docket),
          question_(question),
          memories_(memories),
          near_(hearing.scene_, hearing.view_, asked_tiles()) {}

    /// Decides what it can; for each plea of the docket the reach that it needs, or 0 where it is decided.
    Bulk<double> hear(Bulk<Ruled>& rulings) {
        Bulk<double> lacking(docket_.plea.size(), 0);
        for_each_of(docket_.sittings, [&](const Sitting& sitting) {
            Bench bench(*this, sitting);
            for (std::size_t i = sitting.first; i < sitting.end; ++i)
                lacking[i] = bench.hear(i, rulings[docket_.plea[i]]);
        });
        return lacking;
    }

  private:
    const Plea& plea(std::size_t place) const { return hearing_.pleas_[docket_.plea[place]]; }

    double searched_px(std::size_t place) const {
        return std::max(docket_.reach_px[place], question_.least_search_px);
    }

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

    /// So near its centre an answer that is seen needs no displacement: that is below what least_px() says of
    /// any triangle's eps. And no farther than triangles were looked for.
    double aside_px(const Sitting& sitting) const {
        double eps_px = unlimited;
        for (std::size_t i = sitting.first; i < sitting.end; ++i) {
            const auto& [bounds, answer, x, y] = plea(i);
            eps_px = std::min(eps_px, answer == PrimitiveId::none ? bounds->background_eps_px()
                                                                  : bounds->least_triangle_eps_px());
        }
        return 0.5 * std::min(least_px(eps_px), question_.least_search_px);
    }

    /// Hears the pleas of a sitting, one after the other.
    class Bench {
      public:
        Bench(const Session& session, const Sitting& sitting)
            : session_(session),
              sitting_(sitting),
              near_(session.near_.of(sitting.tile)),
              memories_(session.memories_.local()),
              estimate_([this] { return gather(); }, memories_.coplanar),
              is_worth_a_glance_(near_.size() <= triangles_per_plea * (sitting.end - sitting.first)) {
            memories_.acquaintance.forget_if_much();
            if (may_glance()) memories_.glance.turn_to(near_, session.aside_px(sitting));
        }
        Bench(const Bench&) = delete;  // the estimate looks at it

        /// Decides the plea, or returns the reach that it needs.
        double hear(std::size_t place, Ruled& ruled) {
            turn_to(session_.plea(place));
            if (may_glance() && is_seen_at_a_glance()) {
                ruled = seen_at_a_glance;
                return 0;
            }
            const double own_eps_px = memories_.own_eps_px(*plea_);
            plaint_ = {plea_->bounds, plea_->answer, own_eps_px, 0, question().asked};
            const double known_px = session_.docket_.reach_px[place];
            double needed_px = known_px != 0 ? known_px : first_reach * own_eps_px;
            const double searched_px = session_.searched_px(place);
            if (needed_px > searched_px) return needed_px;  // its triangles are not all known
            do {
                plaint_.reach_px = needed_px;
                estimate_.turn_to(plaint_.answer);
                needed_px = hear_within_reach(ruled);
            } while (needed_px != 0 && needed_px <= searched_px);
            return needed_px;
        }

      private:
        const Amendment& amendment() const { return session_.hearing_.amendment_; }
        const Question& question() const { return session_.question_; }

        /// Not any more where most were not seen so.
        bool may_glance() const {
            return question().at_a_glance && is_worth_a_glance_ && missed_ <= seen_ + missed_at_first;
        }
        bool is_seen_at_a_glance() {
            const bool is_seen = memories_.glance.sees(plea_->answer, {plea_->x, plea_->y});
            ++(is_seen ? seen_ : missed_);
            return is_seen;
        }

        void turn_to(const Plea& plea) {
            const bool is_same = plea_ && plea_->x == plea.x && plea_->y == plea.y;
            plea_ = &plea;
            if (is_same) return;
            if (summary_) summary_->look_at(plea.x, plea.y);
        }
        Summary& summary() {
            if (summary_) return *summary_;
            summary_ = &memories_.summary;
            summary_->turn_to(session_.centres(sitting_), near_, session_.renderers_of(sitting_));
            summary_->look_at(plea_->x, plea_->y);
            return *summary_;
        }
        /// What is known summarily is known of the law.
        double hear_within_reach(Ruled& ruled) {
            if (amendment()) return hear_at_length(ruled);
            if (const std::optional<Ruled> known = summary().rule(plaint_, estimate_)) {
                ruled = *known;
                return 0;
            }
            const double lacking_px = summary().lacking_reach_px(plaint_);
            return lacking_px != 0 ? lacking_px : hear_at_length(ruled);
        }
        double hear_at_length(Ruled& ruled) {
            const Neighbourhood& around = estimate_.around();
            if (around.eps_px > plaint_.reach_px) return around.eps_px;
            ruled = {decide(around, plaint_.answer, memories_.coplanar), around.eps_px, std::nullopt};
            if (plaint_.asked != Asked::standing && ruled.decision.standing == Standing::visible)
                ruled.displacement_over_eps = displacement_over_eps(estimate_);
            return 0;
        }
        /// What stands around the plea, as far as the plaint's reach, as the law or the amendment has it.
        Neighbourhood gather() const {
            Site site{plea_->x, plea_->y, plaint_.reach_px, {}};
            for (const std::uint32_t t : near_)
                if (memories_.acquaintance.of(t).filter.is_near(site.x, site.y, site.reach_px))
                    site.triangles.push_back(t);
            const auto look_up = [&](std::uint32_t t) -> const TriangleOfView& {
                return memories_.acquaintance.of(t, *plea_->bounds).of_view;
            };
            Neighbourhood around =
                neighbourhood_of(session_.hearing_.view_, site, plaint_.own_eps_px, look_up);
            if (amendment()) amendment()(around, plea_->answer);
            return around;
        }

        const Session& session_;
        const Sitting& sitting_;
        std::span<const std::uint32_t> near_;
        Memories& memories_;
        Estimate estimate_;
        Summary* summary_ = nullptr;  ///< once it turned to the tile
        const Plea* plea_ = nullptr;  ///< at hand
        Plaint plaint_;
        bool is_worth_a_glance_;
        std::size_t seen_ = 0, missed_ = 0;  ///< at a glance
    };

    const Hearing& hearing_;
    const Docket& docket_;
    Question question_;
    ThreadMemories& memories_;
    TrianglesByTile near_;
};

/// Pixels of a tile mostly follow each other.
auto Hearing::runs_of_tiles() const -> std::vector<Run> {
    const Tiles tiles(view_);
    std::vector<std::vector<Run>> runs((pleas_.size() + pleas_sorted - 1) / pleas_sorted);
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t some) {
        std::vector<Run> found;
        const std::size_t end = std::min(pleas_.size(), (some + 1) * pleas_sorted);
        for (std::size_t i = some * pleas_sorted; i < end; ++i) {
            const Plea& plea = pleas_[i];
            if (!plea.bounds) continue;
            const std::size_t tile = tiles.of(plea.x, plea.y);
            if (found.empty() || found.back().tile != tile)
                found.push_back({.tile = tile, .first = std::uint32_t(i)});
            found.back().end = std::uint32_t(i + 1);
            ++found.back().pleas;
        }
        runs[some] = std::move(found);
    });
    std::vector<Run> all;
    for (const std::vector<Run>& some : runs) all.insert(all.end(), some.begin(), some.end());
    return all;
}

auto Hearing::docket_of_all() const -> Docket {
    std::vector<Run> runs = runs_of_tiles();
    const Tiles tiles(view_);
    // counted two places ahead, so that giving places leaves each tile's end where the next's first belongs
    std::vector<std::uint32_t> first(tiles.count() + 2);
    for (const Run& run : runs) first[run.tile + 2] += run.pleas;
    for (std::size_t t = 2; t < first.size(); ++t) first[t] += first[t - 1];
    for (Run& run : runs) run.place = std::exchange(first[run.tile + 1], first[run.tile + 1] + run.pleas);
    const std::size_t count = first.back();
    Docket docket{Bulk<std::uint32_t>(count), Bulk<double>(count), {}};
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t r) {
        std::uint32_t place = runs[r].place;
        for (std::uint32_t i = runs[r].first; i < runs[r].end; ++i) {
            if (!pleas_[i].bounds) continue;
            docket.plea[place] = i;
            docket.reach_px[place++] = 0;
        }
    });
    for_each_by_blocks(tiles, [&](std::size_t t) {
        if (first[t] != first[t + 1]) docket.sittings.push_back({t, first[t], first[t + 1]});
    });
    return docket;
}

/// A sample says, of the pleas of both renderers: where it is wrong, that costs another search, or knowledge
/// of triangles that is made twice.
double Hearing::likely_reach_px(const Docket& docket, Memories& memories) const {
    const std::size_t stride = docket.sittings.size() / sittings_sampled + 1;
    double reach_px = 0;
    for (std::size_t s = 0; s < docket.sittings.size(); s += stride) {
        const auto [tile, first, end] = docket.sittings[s];
        for (std::size_t i = first; i < std::min(end, first + pleas_sampled); ++i)
            reach_px = std::max(reach_px, memories.first_reach_px(pleas_[docket.plea[i]]));
    }
    return reach_px;
}

void Hearing::set_reach(Docket& docket, const Sitting& sitting, Memories& memories) const {
    memories.acquaintance.forget_if_much();
    for (std::size_t i = sitting.first; i < sitting.end; ++i)
        docket.reach_px[i] = memories.first_reach_px(pleas_[docket.plea[i]]);
}

auto Hearing::left_over(const Docket& docket, const Bulk<double>& lacking) const -> Docket {
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

/// Where no plane may cut what a glance does not look at; and where pleas are enough for a look at all
/// vertices.
bool Hearing::may_glance(Asked asked) const {
    return asked == Asked::without_square && !amendment_ &&
           vertices_per_plea * pleas_.size() >= scene_.vertices.position_world.size() &&
           lies_between_planes(scene_, view_);
}

/// The squares that grow beyond their first reach are looked at once more with their full reach.
Bulk<Ruled> Hearing::hear(Bulk<Plea> pleas, Asked asked) {
    pleas_ = std::move(pleas);
    Bulk<Ruled> rulings(pleas_.size());
    tbb::parallel_for(std::size_t(0), rulings.size(), [&](std::size_t i) {
        if (!pleas_[i].bounds) rulings[i] = Ruled{};
    });
    ThreadMemories memories([&] { return Memories(scene_, view_); });
    Docket docket = docket_of_all();
    const double likely_px = likely_reach_px(docket, memories.local());
    if (likely_px > most_searched_px)
        for_each_of(docket.sittings, [&](const Sitting& s) { set_reach(docket, s, memories.local()); });
    const double least_search_px = std::min(searched_over_reach * likely_px, most_searched_px);
    Session::Question question{asked, may_glance(asked), least_search_px};
    while (!docket.plea.empty()) {
        docket = left_over(docket, Session(*this, docket, question, memories).hear(rulings));
        question.at_a_glance = false;
    }
    return rulings;
}

}  // namespace zproof
