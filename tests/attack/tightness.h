/// How far beyond its promise a wrong pixel may lie and pass.
#pragma once

#include <map>
#include <span>
#include <string>

#include "tests/attack/attack_scenes.h"

namespace zproof::attack {

/// With more, the rationals of a picture take seconds.
inline constexpr std::size_t most_planted_triangles = 60;

/// What is wrong, and who promised what.
struct Row {
    std::string wrong, promise;

    auto operator<=>(const Row&) const = default;
};

struct Tally {
    std::uint64_t planted = 0, undecidable = 0, passed = 0;
    double farthest = 0;  ///< of those that passed, as a multiple of the promise
    std::string where{};  ///< this one, with what was said
};

class Tightness {
  public:
    /// Wrong pixels of every kind, by 1.01, 1.1 and 2 times what is promised.
    void plant_in(const AttackScene& scene);

    const std::map<Row, Tally>& rows() const { return rows_; }
    std::uint64_t planted() const;

  private:
    struct Judged;
    void count(const Judged& judged);
    void plant_places(const class Trial& trial);
    void plant_snapped(const class Trial& trial);
    void plant_labels(const class Trial& trial);
    void plant_values(const class Trial& trial);

    std::map<Row, Tally> rows_;
};

}  // namespace zproof::attack
