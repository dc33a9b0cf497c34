#include "cli/plan/assignment.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace zproof {
namespace {

/// One view of one scene for one renderer.
struct Unit {
    PlannedScene* scene;
    std::size_t view;

    double seconds() const { return scene->view_s[view]; }
    double seconds_alone() const { return scene->setup_s + seconds(); }
    int& shard() const { return scene->shards[view]; }
};

std::vector<Unit> units_of(Plan& plan) {
    std::vector<Unit> units;
    for (PlannedRun& run : plan.runs)
        for (PlannedScene& scene : run.scenes)
            for (std::size_t view = 0; view < scene.view_s.size(); ++view) units.push_back({&scene, view});
    return units;
}

/// Shards by the time at which they end, the earliest first.
class Shards {
  public:
    explicit Shards(int count) : end_s_(std::size_t(count), 0) {
        for (int number = 1; number <= count; ++number) by_end_.insert({0, number});
    }

    int first_to_end() const { return by_end_.begin()->second; }
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

/// Where the unit would end earliest: on the shard that ends first, or on one that has set its scene up.
int best_shard(const Unit& unit, const Shards& shards, const std::set<int>& set_up) {
    int best = shards.first_to_end();
    const auto end_on = [&](int number) {
        return shards.end_s(number) + (set_up.contains(number) ? unit.seconds() : unit.seconds_alone());
    };
    for (const int number : set_up)
        if (end_on(number) <= end_on(best)) best = number;
    return best;
}

}  // namespace

void assign(Plan& plan) {
    std::vector<Unit> units = units_of(plan);
    std::ranges::stable_sort(units, std::greater{}, &Unit::seconds_alone);
    Shards shards(plan.shards);
    std::map<const PlannedScene*, std::set<int>> set_up;
    for (const Unit& unit : units) {
        std::set<int>& those = set_up[unit.scene];
        const int number = best_shard(unit, shards, those);
        shards.add(number, those.insert(number).second ? unit.seconds_alone() : unit.seconds());
        unit.shard() = number;
    }
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
