#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "compare/bounds/pixel_coord.h"
#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/renamed_ids.h"

namespace zproof {

namespace {

/// Numbers from the least to the greatest, both of which belong to them.
struct Span {
    double least = 0x1p32, greatest = 0;

    void add(double value) {
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    bool holds(double value) const { return least <= value && value <= greatest; }
    double bits() const { return std::log2(greatest - least + 1); }
};

/// What is told of each pixel, and what should be: ids, or labels where the frame says labels.
class ToldIds {
  public:
    explicit ToldIds(const DiagnosisInput& input)
        : told_(input.said ? input.said->ids : input.candidate.frame.primitive),
          seen_(input.reference.frame.primitive),
          labels_(input.said ? &input.said->labels : nullptr) {}

    Resolution size() const { return seen_.size(); }
    std::uint32_t told(int x, int y) const { return std::uint32_t(told_.at(x, y)); }
    std::uint32_t told(const Claim& claim) const {
        return std::uint32_t(labels_ ? claim.label : claim.answer.primitive);
    }
    PrimitiveId seen(int x, int y) const { return seen_.at(x, y); }
    std::uint32_t right(int x, int y) const {
        const PrimitiveId id = seen_.at(x, y);
        return std::uint32_t(labels_ ? label_of(*labels_, id) : id);
    }
    /// The right ones of the pixel and its neighbours.
    std::set<std::uint32_t> around(int x, int y) const {
        std::set<std::uint32_t> all;
        for (int ny = y - 1; ny <= y + 1; ++ny)
            for (int nx = x - 1; nx <= x + 1; ++nx)
                if (holds(size(), {nx, ny, {}})) all.insert(right(nx, ny));
        return all;
    }

  private:
    const Plane<PrimitiveId>& told_;
    const Plane<PrimitiveId>& seen_;
    const TriangleLabels* labels_;
};

/// Whole numbers of a byte each, or one number of four.
std::array<double, 4> parts_of(std::uint32_t id, bool as_bytes) {
    if (!as_bytes) return {double(id), 0, 0, 0};
    return {double(id & 0xFF), double(id >> 8 & 0xFF), double(id >> 16 & 0xFF), double(id >> 24)};
}

/// How ids were averaged.
struct Blend {
    bool as_bytes;
    int samples;

    /// Is `told` a mean of samples of both ids, each part rounded?
    bool is_of(std::uint32_t told, std::uint32_t one, std::uint32_t other) const {
        const auto t = parts_of(told, as_bytes), p = parts_of(one, as_bytes), q = parts_of(other, as_bytes);
        double low = 1, high = samples - 1;  // samples of the other one
        for (std::size_t k = 0; k < t.size(); ++k) {
            const double way = (q[k] - p[k]) / samples, from = t[k] - p[k];
            if (way == 0 && from != 0) return false;
            if (way == 0) continue;
            const auto [least, greatest] = std::minmax({(from - 0.5) / way, (from + 0.5) / way});
            low = std::max(low, least);
            high = std::min(high, greatest);
        }
        return std::ceil(low) <= high;
    }

    /// log2 of what a mean of these may be; nothing where `told` is none. A mean of two is told by the two
    /// and by how many samples are whose, others by numbers from the least to the greatest.
    std::optional<double> bits(std::uint32_t told, const std::set<std::uint32_t>& of) const {
        double bits = 0;
        std::array<Span, 4> spans;
        for (const std::uint32_t id : of)
            for (std::size_t k = 0; k < spans.size(); ++k) spans[k].add(parts_of(id, as_bytes)[k]);
        for (std::size_t k = 0; k < spans.size(); ++k) {
            if (!spans[k].holds(parts_of(told, as_bytes)[k])) return std::nullopt;
            bits += spans[k].bits();
        }
        const double pairs = double(of.size()) * double(of.size() - 1) / 2;
        for (const std::uint32_t one : of)
            for (const std::uint32_t other : of)
                if (one < other && is_of(told, one, other))
                    return std::min(bits, std::log2(pairs * (samples - 1)));
        return bits;
    }
};

constexpr std::size_t most_wrong_asked = 4'096;

/// A pixel at an outline tells a mean of the ids around. Nothing where most that are wrong tell one of those.
std::vector<Hypothesis> blended(const DiagnosisInput& input, const Blend& blend) {
    const ToldIds ids(input);
    std::vector<PixelCoord> wrong;
    for (int y = 0; y < ids.size().height; ++y)
        for (int x = 0; x < ids.size().width; ++x)
            if (ids.told(x, y) != ids.right(x, y)) wrong.push_back({x, y});
    const std::size_t step = wrong.size() / most_wrong_asked + 1;
    std::size_t asked = 0, means = 0;
    double bits = 0;
    for (std::size_t i = 0; i < wrong.size(); i += step, ++asked) {
        const auto [x, y] = wrong[i];
        const std::set<std::uint32_t> around = ids.around(x, y);
        const std::optional<double> of_this = blend.bits(ids.told(x, y), around);
        means += of_this && !around.contains(ids.told(x, y));
        bits += of_this.value_or(0);
    }
    if (2 * means <= asked) return {};
    Hypothesis h = as_declared(
        input, {std::string(input.said ? "labels" : "ids") + " are blended by antialiasing",
                blend.as_bytes ? "At outlines the mean of the bytes around is told."
                               : "At outlines the mean of the numbers around is told.",
                "Look at multisampling, filters and resizing of the id target: ids must not be averaged."});
    h.learned_bits = bits * double(wrong.size()) / double(asked);
    h.only_permits = true;
    h.reads_surroundings = true;
    h.restate = [ids, blend](Claim claim) -> std::optional<Claim> {
        const std::uint32_t told = ids.told(claim);
        if (told == ids.right(claim.x, claim.y)) return claim;
        if (!blend.bits(told, ids.around(claim.x, claim.y))) return std::nullopt;
        claim.answer.primitive = ids.seen(claim.x, claim.y);
        return claim;
    };
    return {h};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_blended_ids(const DiagnosisInput& input) {
    if (input.said && input.said->labels.are_absent) return {};
    std::vector<Hypothesis> shortest;
    for (const bool as_bytes : {true, false}) {
        std::vector<Hypothesis> all;
        for (const int samples : {4, 8, 16, 255})
            for (const Hypothesis& h : blended(input, {as_bytes, samples})) all.push_back(h);
        if (all.empty()) continue;
        shortest.push_back(*std::ranges::min_element(all, {}, &Hypothesis::learned_bits));
        shortest.back().learned_bits += std::log2(4);
    }
    return shortest;
}

}  // namespace zproof
