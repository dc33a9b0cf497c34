#include "compare/agreement.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "compare/memory.h"
#include "compare/shown_triangles.h"

namespace zproof {

namespace {

constexpr int tile_width = 64, tile_height = 16;

/// What both witnesses may say of one triangle's depth.
struct DepthOfBoth {
    TriangleDepth candidate, reference;
};

/// Few triangles are ever asked about outside of the laws of a tile.
constexpr std::size_t remembered_triangles = 64;

/// Pixels [begin, end) of a row at which both frames name the same triangle (or none), or each one of its
/// own.
struct Run {
    PrimitiveId candidate, reference;
    int begin, end;

    bool agrees() const { return candidate == reference; }
};

Run run_at(std::span<const PrimitiveId> candidate, std::span<const PrimitiveId> reference, int begin,
           int limit) {
    const auto at = [](std::span<const PrimitiveId> row, int x) { return row[std::size_t(x)]; };
    Run run{at(candidate, begin), at(reference, begin), begin, begin + 1};
    while (run.end < limit && at(candidate, run.end) == run.candidate &&
           at(reference, run.end) == run.reference)
        ++run.end;
    return run;
}

/// A piece of a row within one tile: which laws its depths are held against, and how far they go.
struct Strip {
    std::array<std::uint32_t, tile_width> candidate_law, reference_law;
    std::array<std::uint32_t, tile_width> is_shared;  ///< do both show the same triangle?
    std::array<double, tile_width> candidate_ratio, reference_ratio;
};

/// Pixels [left, right) x [top, bottom).
struct Tile {
    int left, top, right, bottom;
};

/// Two records in the making. Neighbouring pixels often fall into one bin: they are counted side by side.
class Count {
  public:
    using Bins = std::array<std::int32_t, tile_width>;

    /// Counts the pixels whose depths are both settled, and says which are.
    const Bins& add(const Strip& strip) {
        Bins theirs;
        bin_ratios({strip.candidate_ratio, strip.reference_ratio, strip.is_shared},
                   {ours_.data(), theirs.data(), candidate_.most.data(), reference_.most.data()});
        for (std::size_t i = 0; i < tile_width; ++i) {
            ++candidate_.bins[i % lanes][std::size_t(ours_[i])];
            ++reference_.bins[i % lanes][std::size_t(theirs[i])];
        }
        return ours_;
    }
    void add_to(Tally& tally) const {
        candidate_.add_to(tally.candidate);
        reference_.add_to(tally.reference);
    }

  private:
    static constexpr std::size_t lanes = 4;
    struct Record {
        std::array<std::array<std::uint64_t, ratio_bins + 1>, lanes> bins{};
        std::array<double, RowOfDepths::together> most{};

        void add_to(BoundRecord& record) const {
            for (const double m : most)
                record.max_error_over_bound = std::max(record.max_error_over_bound, m);
            for (const auto& lane : bins)
                for (std::size_t i = 0; i < record.histogram.size(); ++i) record.histogram[i] += lane[i];
        }
    };
    Bins ours_{};
    Record candidate_, reference_;
};

/// A look at both witnesses, tile by tile or at one pixel.
class Comparison {
  public:
    Comparison(const Scene& scene, const Witness& candidate, const Witness& reference)
        : triangle_count_(scene.triangles.size()),
          candidate_(candidate),
          reference_(reference),
          shown_(candidate, reference),
          triangles_(remembered_triangles) {}

    /// Compares the pixels of a tile; `rows` are the findings of its rows.
    void compare(const Tile& tile, std::span<Findings> rows) {
        shown_.clear();
        for (int y = tile.top; y < tile.bottom; ++y) look_up_laws(tile, y);
        shown_.make_laws();
        for (int y = tile.top; y < tile.bottom; ++y) {
            Strip& strip = strips_[std::size_t(y - tile.top)];
            hold(tile, y, strip);
            settle(tile, y, strip, rows[std::size_t(y - tile.top)]);
        }
    }

    /// Adds what was counted at pixels that double precision settled.
    void add_to(Tally& tally) const { count_.add_to(tally); }

    OpenPixel look_at(int x, int y, double known_reference_ratio = unsettled) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        OpenPixel open;
        Finding& f = open.finding;
        f = {.x = x,
             .y = y,
             .candidate = candidate_.answer_at(x, y),
             .reference = reference_.answer_at(x, y),
             .candidate_depth = {nan, nan, nan},
             .error_over_bound = nan};
        open.candidate_invalid = is_invalid(f.candidate, triangle_count_);
        open.reference_invalid = is_invalid(f.reference, triangle_count_);
        if (!open.candidate_invalid && f.candidate.primitive != PrimitiveId::none) {
            const DepthCheck check =
                candidate_.check(depth_of_both(f.candidate.primitive).candidate, f.candidate, x, y);
            f.candidate_depth = check.bound;
            f.error_over_bound = check.error_over_bound;
            open.candidate_depth_lawful = check.lawful;
        }
        if (known_reference_ratio != unsettled) {
            open.reference_error_over_bound = known_reference_ratio;
        } else if (!open.reference_invalid && f.reference.primitive != PrimitiveId::none) {
            const DepthCheck check =
                reference_.check(depth_of_both(f.reference.primitive).reference, f.reference, x, y);
            open.reference_error_over_bound = check.error_over_bound;
            open.reference_depth_lawful = check.lawful;
        }
        return open;
    }

  private:
    const DepthOfBoth& depth_of_both(PrimitiveId primitive) {
        return triangles_(std::uint32_t(primitive), [&] {
            const TriangleInView triangle = candidate_.triangle_in_view(primitive);
            return DepthOfBoth{depth_of(triangle, candidate_.bounds()),
                               depth_of(triangle, reference_.bounds())};
        });
    }

    void look_up_laws(const Tile& tile, int y) {
        Strip& strip = strips_[std::size_t(y - tile.top)];
        const auto law_of = [&](PrimitiveId id) {
            return std::size_t(id) < triangle_count_ ? shown_.place_of(id) : 0;
        };
        strip.candidate_law.fill(0);
        strip.reference_law.fill(0);
        strip.is_shared.fill(0);
        const auto ours = candidate_.frame().primitive.row(y), theirs = reference_.frame().primitive.row(y);
        for (int x = tile.left; x < tile.right;) {
            const Run run = run_at(ours, theirs, x, tile.right);
            const std::uint32_t law = law_of(run.candidate),
                                other = run.agrees() ? law : law_of(run.reference);
            for (; x < run.end; ++x) {
                const auto i = std::size_t(x - tile.left);
                strip.candidate_law[i] = law;
                strip.reference_law[i] = other;
                strip.is_shared[i] = std::uint32_t(run.agrees());
            }
        }
    }

    void hold(const Tile& tile, int y, Strip& strip) const {
        const auto width = std::size_t(tile.right - tile.left);
        const bool perspective = candidate_.projection() == Projection::perspective;
        const auto hold_by = perspective ? hold_perspective : hold_parallel;
        const auto hold = [&](const Witness& witness, std::span<const DepthLaw> laws, const auto& which,
                              auto& ratio) {
            std::array<float, tile_width> depth{};
            std::ranges::copy(witness.frame().camera_depth.row(y).subspan(std::size_t(tile.left), width),
                              depth.begin());
            hold_by(laws, {tile.left, y, which, depth.data()}, ratio.data());
        };
        hold(candidate_, shown_.candidate_laws(), strip.candidate_law, strip.candidate_ratio);
        hold(reference_, shown_.reference_laws(), strip.reference_law, strip.reference_ratio);
    }

    void settle(const Tile& tile, int y, const Strip& strip, Findings& found) {
        const Count::Bins& bins = count_.add(strip);
        for (int x = tile.left; x < tile.right; ++x)
            if (bins[std::size_t(x - tile.left)] == unsettled_bin)
                settle(x, y, strip, std::size_t(x - tile.left), found);
    }

    void settle(int x, int y, const Strip& strip, std::size_t i, Findings& found) {
        const Answer ours = candidate_.answer_at(x, y), theirs = reference_.answer_at(x, y);
        if (ours.primitive != theirs.primitive)
            return found.open.push_back(look_at(x, y, strip.reference_ratio[i]));
        const bool is_bare = ours.primitive == PrimitiveId::none;
        if (is_bare && ours.camera_depth == background_depth && theirs.camera_depth == background_depth)
            return;
        if (std::size_t(ours.primitive) < triangle_count_)
            settle(look_at(x, y), found);
        else
            found.open.push_back(look_at(x, y));
    }

    /// Double precision did not say that both depths are lawful.
    void settle(const OpenPixel& pixel, Findings& found) {
        if (!pixel.candidate_invalid && !pixel.reference_invalid) {
            count(found.tally.candidate, pixel.finding.error_over_bound);
            count(found.tally.reference, pixel.reference_error_over_bound);
        }
        if (!is_settled(pixel)) found.open.push_back(pixel);
    }

    std::size_t triangle_count_;
    const Witness &candidate_, &reference_;
    ShownTriangles shown_;
    std::array<Strip, tile_height> strips_;
    Count count_;
    Memory<std::uint32_t, DepthOfBoth> triangles_;
};

}  // namespace

bool is_settled(const OpenPixel& p) {
    return p.finding.candidate.primitive == p.finding.reference.primitive && !p.candidate_invalid &&
           !p.reference_invalid && p.candidate_depth_lawful && p.reference_depth_lawful;
}

void count(BoundRecord& record, double error_over_bound) {
    record.max_error_over_bound = std::max(record.max_error_over_bound, error_over_bound);
    const double bin = std::min(error_over_bound * 20, 20.0);
    ++record.histogram[bin >= 0 ? std::size_t(bin) : 20];
}

void add(Tally& sum, const Tally& part) {
    const auto add_record = [](BoundRecord& s, const BoundRecord& p) {
        s.max_error_over_bound = std::max(s.max_error_over_bound, p.max_error_over_bound);
        for (std::size_t i = 0; i < s.histogram.size(); ++i) s.histogram[i] += p.histogram[i];
    };
    add_record(sum.candidate, part.candidate);
    add_record(sum.reference, part.reference);
}

Findings compare_rows(const Scene& scene, const View& view, const Witness& candidate,
                      const Witness& reference, int top, int bottom) {
    Findings found;
    Comparison comparison(scene, candidate, reference);
    std::vector<Findings> rows(std::size_t(bottom - top));
    for (int tile_top = top; tile_top < bottom; tile_top += tile_height)
        for (int left = 0; left < view.width; left += tile_width) {
            const Tile tile{left, tile_top, std::min(left + tile_width, view.width),
                            std::min(tile_top + tile_height, bottom)};
            comparison.compare(tile, std::span(rows).subspan(std::size_t(tile_top - top)));
        }
    for (const Findings& row : rows) {
        add(found.tally, row.tally);
        found.open.insert(found.open.end(), row.open.begin(), row.open.end());
    }
    comparison.add_to(found.tally);
    return found;
}

OpenPixel open_pixel(const Scene& scene, const Witness& candidate, const Witness& reference, int x, int y) {
    return Comparison(scene, candidate, reference).look_at(x, y);
}

}  // namespace zproof
