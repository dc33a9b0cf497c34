/// Shards of one run, put together again.
#pragma once

#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

/// Takes shards in, one after the other and in any order; holds their views and no more.
class Merging {
  public:
    /// Throws ReportError naming the shard where it is not of the same run as those before. `name` is for
    /// messages.
    void add(Results shard, const std::string& name);

    /// Was this shard added?
    bool has(int number) const { return std::size_t(number) < holders_.size() && !holder_of(number).empty(); }

    /// What one run of the whole selection would have found out: the views in the order of the selection,
    /// each with the times that its shard took. Throws ReportError where a shard or a view is missing. To be
    /// called once, with at least one shard.
    Results whole() &&;

    /// The results where some may be missing: these stand for what is not there, and what is there as well is
    /// dropped.
    Results partial(std::vector<ViewResult> missing) &&;

  private:
    const std::string& holder_of(int number) const { return holders_[std::size_t(number)]; }
    void require_same_run(const Results& shard, const std::string& name) const;
    void hold(const Shard& shard, const std::string& name);
    void require_all_shards() const;
    Results put_together() &&;

    Results all_;                       ///< the first shard's facts, and the views of all
    std::string first_;                 ///< its name
    std::vector<std::string> holders_;  ///< of each shard, by number; empty: nobody
};

/// The words without those that are a shard's own: "--shard X", "--empty-shard X", "--exit-zero" and "-o X"
/// ("--out X"), in all ways to write them.
std::vector<std::string> without_shard_words(const std::vector<std::string>& argv);

}  // namespace zproof
