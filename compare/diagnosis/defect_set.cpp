#include "compare/diagnosis/defect_set.h"

#include <algorithm>

namespace zproof {

namespace {

constexpr std::size_t most_looked_at = 20'000;  ///< defects that the next cause is sought among

/// A number in [0, 1) that looks random (SplitMix64, Steele, Lea and Flood 2014).
double scattered(std::uint64_t k) {
    std::uint64_t z = (k + 1) * 0x9E37'79B9'7F4A'7C15u;
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9u;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// One of every `total / most` in a row, at a scattered place, so that no stride meets the image's columns.
std::vector<std::size_t> spread(std::size_t total, std::size_t most) {
    const std::size_t count = std::min(total, most);
    std::vector<std::size_t> chosen(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double place = double(k) + (count < total ? scattered(k) : 0.0);
        chosen[k] = std::min(total - 1, std::size_t(place * double(total) / double(count)));
    }
    return chosen;
}

/// The cells of a grid over the view, and those that hold a defect.
class CellGrid {
  public:
    CellGrid(const Verdict& verdict, Resolution cell)
        : verdict_(verdict),
          cell_(cell),
          holds_defect_({cells_along(verdict.classes.size().width, cell.width),
                         cells_along(verdict.classes.size().height, cell.height)}) {
        for (const Finding& f : verdict.findings)
            if (is_defect(f.verdict)) holds_defect_.at(f.x / cell.width, f.y / cell.height) = 1;
    }

    double count() const { return double(holds_defect_.pixels().size()); }
    double with_defects() const { return double(std::ranges::count(holds_defect_.pixels(), 1)); }
    /// The pixels that agree in cells that hold a defect.
    std::vector<std::uint32_t> agreeing() const {
        const Resolution size = verdict_.classes.size();
        std::vector<std::uint32_t> pixels;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (verdict_.classes.at(x, y) == PixelClass::agree &&
                    holds_defect_.at(x / cell_.width, y / cell_.height))
                    pixels.push_back(std::uint32_t(y) * std::uint32_t(size.width) + std::uint32_t(x));
        return pixels;
    }

  private:
    static int cells_along(int side, int cell) { return (side + cell - 1) / cell; }

    const Verdict& verdict_;
    Resolution cell_;
    Plane<std::uint8_t> holds_defect_;
};

}  // namespace

void ClaimSample::add(std::span<const Claim> some, double of_pixels) {
    claims.insert(claims.end(), some.begin(), some.end());
    weights.insert(weights.end(), some.size(), of_pixels / double(some.size()));
}

DefectSet::DefectSet(const DiagnosisInput& input, const Verdict& verdict)
    : candidate_(input.candidate.frame), said_(input.said), verdict_(verdict) {
    for (const Finding& f : verdict.findings)
        if (is_defect(f.verdict) && f.verdict != PixelClass::wrong_attribute)
            defects_.push_back(claim_at({f.x, f.y}));
}

bool DefectSet::are_all_depths() const {
    return std::ranges::all_of(defects_, [&](const Claim& claim) {
        return verdict_.classes.at(claim.x, claim.y) == PixelClass::wrong_depth;
    });
}

std::vector<Claim> DefectSet::many() const { return defects(most_looked_at).claims; }

void DefectSet::keep(std::vector<Claim> left) {
    pixels_each_ *= double(defects_.size()) / double(std::min(defects_.size(), most_looked_at));
    defects_ = std::move(left);
}

ClaimSample DefectSet::defects(std::size_t most) const {
    std::vector<Claim> claims;
    for (const std::size_t i : spread(defects_.size(), most)) claims.push_back(defects_[i]);
    ClaimSample sample;
    sample.add(claims, pixel_count());
    return sample;
}

ClaimSample DefectSet::agreeing(Resolution cell, std::size_t most) {
    const Agreeing& all = agreeing_beside(cell);
    ClaimSample sample;
    for (const std::vector<std::uint32_t>* part : {&all.at_edges, &all.elsewhere}) {
        std::vector<Claim> claims;
        for (const std::size_t i : spread(part->size(), most / 2))
            claims.push_back(claim_at(place_of((*part)[i])));
        sample.add(claims, double(part->size()));
    }
    return sample;
}

const DefectSet::Agreeing& DefectSet::agreeing_beside(Resolution cell) {
    const auto [entry, is_new] = agreeing_.try_emplace({cell.width, cell.height});
    if (!is_new) return entry->second;
    const CellGrid grid(verdict_, cell);
    for (const std::uint32_t pixel : grid.agreeing())
        (is_at_edge(pixel) ? entry->second.at_edges : entry->second.elsewhere).push_back(pixel);
    entry->second.cells = {grid.with_defects(), grid.count()};
    return entry->second;
}

PixelCoord DefectSet::place_of(std::uint32_t pixel) const {
    const auto width = std::uint32_t(candidate_.size().width);
    return {int(pixel % width), int(pixel / width)};
}

Claim DefectSet::claim_at(const PixelCoord& place) const {
    const auto [x, y] = place;
    Claim claim{x, y, {candidate_.primitive.at(x, y), candidate_.camera_depth.at(x, y)}};
    if (said_ && !said_->labels.are_absent) claim.label = said_->ids.at(x, y);
    return claim;
}

bool DefectSet::is_at_edge(std::uint32_t pixel) const {
    const auto [x, y] = place_of(pixel);
    const Resolution size = candidate_.size();
    const PrimitiveId own = candidate_.primitive.at(x, y);
    return (x > 0 && candidate_.primitive.at(x - 1, y) != own) ||
           (y > 0 && candidate_.primitive.at(x, y - 1) != own) ||
           (x + 1 < size.width && candidate_.primitive.at(x + 1, y) != own) ||
           (y + 1 < size.height && candidate_.primitive.at(x, y + 1) != own);
}

}  // namespace zproof
