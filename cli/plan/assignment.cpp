#include "cli/plan/assignment.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace zproof {
namespace {

/// Views of one scene for one renderer that stay together.
struct Piece {
    PlannedScene* scene;
    std::size_t first, count;
    double views_s;

    double alone_s() const { return scene->setup_s + views_s; }
    void give_to(int shard) const { std::fill_n(scene->shards.begin() + long(first), count, shard); }
};

/// Cuts a scene into pieces that take no longer than `most_s` alone, but for single views.
void cut(PlannedScene& scene, double most_s, std::vector<Piece>& pieces) {
    const std::size_t before = pieces.size();
    for (std::size_t view = 0; view < scene.view_s.size(); ++view) {
        const double view_s = scene.view_s[view];
        if (pieces.size() == before || pieces.back().alone_s() + view_s > most_s)
            pieces.push_back({&scene, view, 0, 0});
        ++pieces.back().count;
        pieces.back().views_s += view_s;
    }
}

/// The longest first.
std::vector<Piece> pieces_of(Plan& plan, double most_s) {
    std::vector<Piece> pieces;
    for (PlannedRun& run : plan.runs)
        for (PlannedScene& scene : run.scenes) cut(scene, most_s, pieces);
    std::ranges::stable_sort(pieces, std::greater{}, &Piece::alone_s);
    return pieces;
}

/// Shards by the time at which they end, the earliest first.
class Shards {
  public:
    explicit Shards(int count) : end_s_(std::size_t(count), 0) {
        for (int number = 1; number <= count; ++number) by_end_.insert({0, number});
    }

    int first_to_end() const { return by_end_.begin()->second; }
    double last_end_s() const { return by_end_.rbegin()->first; }
    double end_s(int number) const { return end_s_[std::size_t(number - 1)]; }

    void add(int number, double seconds) {
        by_end_.erase({end_s(number), number});
        end_s_[std::size_t(number - 1)] += seconds;
        by_end_.insert({end_s(number), number});
    }

  private:
    std::vector<double> end_s_;
    std::set<std::pair<double, int>> by_end_;
};

/// Where the piece would end earliest: on the shard that ends first, or on one that has set its scene up.
int best_shard(const Piece& piece, const Shards& shards, const std::set<int>& set_up) {
    int best = shards.first_to_end();
    const auto end_on = [&](int number) {
        return shards.end_s(number) + (set_up.contains(number) ? piece.views_s : piece.alone_s());
    };
    for (const int number : set_up)
        if (end_on(number) <= end_on(best)) best = number;
    return best;
}

/// Returns when the last shard ends.
double assign_pieces(Plan& plan, double most_s) {
    Shards shards(plan.shards);
    std::map<const PlannedScene*, std::set<int>> set_up;
    for (const Piece& piece : pieces_of(plan, most_s)) {
        std::set<int>& those = set_up[piece.scene];
        const int number = best_shard(piece, shards, those);
        shards.add(number, those.insert(number).second ? piece.alone_s() : piece.views_s);
        piece.give_to(number);
    }
    return shards.last_end_s();
}

}  // namespace

void assign(Plan& plan) {
    constexpr int halvings = 7;
    double best_s = std::numeric_limits<double>::infinity(), best_cut_s = 0, cut_s = least_makespan_s(plan);
    for (int i = 0; i <= halvings; ++i, cut_s = i < halvings ? cut_s / 2 : 0)
        if (const double makespan_s = assign_pieces(plan, cut_s); makespan_s < best_s)
            best_s = makespan_s, best_cut_s = cut_s;
    assign_pieces(plan, best_cut_s);
}

std::vector<double> shard_seconds(const Plan& plan) {
    std::vector<double> seconds(std::size_t(plan.shards), 0);
    for (const PlannedRun& run : plan.runs)
        for (const PlannedScene& scene : run.scenes) {
            std::set<int> set_up;
            for (std::size_t view = 0; view < scene.shards.size(); ++view) {
                const int number = scene.shards[view];
                seconds[std::size_t(number - 1)] +=
                    scene.view_s[view] + (set_up.insert(number).second ? scene.setup_s : 0);
            }
        }
    return seconds;
}

double least_makespan_s(const Plan& plan) {
    double longest = 0, all = 0;
    for (const PlannedRun& run : plan.runs)
        for (const PlannedScene& scene : run.scenes) {
            longest = std::max(longest, scene.setup_s + std::ranges::max(scene.view_s));
            all += scene.setup_s + std::accumulate(scene.view_s.begin(), scene.view_s.end(), 0.0);
        }
    return std::max(longest, all / plan.shards);
}

}  // namespace zproof
