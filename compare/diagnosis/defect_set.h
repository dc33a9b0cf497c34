/// What a hypothesis must explain, and what it must not break: samples of a view's defects, and of its pixels
/// that agree.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// Claims. Each stands for `weight` of the view's pixels.
struct ClaimSample {
    std::vector<Claim> claims;
    std::vector<double> weights;

    void add(std::span<const Claim> some, double of_pixels);
};

class DefectSet {
  public:
    DefectSet(const DiagnosisInput& input, const Verdict& verdict);

    std::size_t defect_count() const { return defects_.size(); }
    bool are_all_depths() const;
    /// All of them, or an evenly spread part where they are very many.
    std::vector<Claim> many() const;
    /// Keeps those alone that a hypothesis left: some of many().
    void keep(std::vector<Claim> left);
    double pixel_count() const { return pixels_each_ * double(defects_.size()); }
    ClaimSample defects(std::size_t most) const;
    /// A sample of the cells that hold a defect. Half of them lie where the candidate's id changes, if any
    /// do: that is where much is left open.
    ClaimSample agreeing(Resolution cell, std::size_t most);

    /// How many cells a grid of them has.
    struct Cells {
        double with_defects = 0, all = 0;
    };
    Cells cells(Resolution cell) { return agreeing_beside(cell).cells; }

  private:
    struct Agreeing {
        std::vector<std::uint32_t> at_edges, elsewhere;
        Cells cells;
    };

    const Agreeing& agreeing_beside(Resolution cell);
    PixelCoord place_of(std::uint32_t pixel) const;
    Claim claim_at(const PixelCoord& place) const;
    bool is_at_edge(std::uint32_t pixel) const;

    const Frame& candidate_;
    const SaidLabels* said_;
    const Verdict& verdict_;
    std::vector<Claim> defects_;
    double pixels_each_ = 1;                            ///< that a defect stands for
    std::map<std::pair<int, int>, Agreeing> agreeing_;  ///< by width and height of the cell
};

}  // namespace zproof
