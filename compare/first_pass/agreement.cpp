#include "compare/first_pass/agreement.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <optional>
#include <span>

#include "compare/first_pass/depth_histograms.h"
#include "compare/first_pass/error_scribe.h"
#include "compare/first_pass/held_depths.h"
#include "compare/first_pass/pixel_look.h"
#include "compare/first_pass/presort.h"
#include "compare/first_pass/run_lens.h"
#include "compare/first_pass/shown_triangles.h"
#include "compare/first_pass/strip_laws.h"
#include "compare/strips/dispatch.h"

namespace zproof {

namespace {

constexpr int tile_width = Strip::width;
/// So that no two threads open pixels of one of the tiles in which those wait.
constexpr int tile_height = Tiles::side_px;

/// Of a tile: more than that, and few pixels share a law.
constexpr std::size_t many_laws = 512;
/// Of a tile's strips, on the average: more than that, many of them of triangles of their own, and runs are
/// looked at by themselves.
constexpr std::size_t many_runs_of_strip = 12;

/// Fetches what follows a strip: what the next tile will read. Into the second cache: the first has no room
/// for all of it. Inline: a function that only fetches does nothing, to a compiler.
template <class T>
[[gnu::always_inline]] inline void fetch_ahead(const T* strip) {
    constexpr std::size_t step = cache_line_bytes / sizeof(T);
    constexpr int to_read = 0, second = 2;
    for (std::size_t i = Strip::width; i < 2 * Strip::width; i += step)
        __builtin_prefetch(strip + i, to_read, second);
}

/// The largest ratios that any part of the image has shown so far. Only what work is saved depends on it.
struct LargestSoFar {
    std::atomic<double> candidate = 0, reference = 0;
};

/// One thread's look at both witnesses, tile by tile.
class Comparison {
  public:
    Comparison(const Scene& scene, const Witness& candidate, const Witness& reference, const Wanted& wanted,
               LargestSoFar& largest)
        : shown_(scene, candidate, reference),
          scene_(scene),
          triangle_count_(scene.triangles.size()),
          candidate_(candidate),
          reference_(reference),
          largest_(largest),
          kernel_(strips::widest_kernel()),
          laws_(scene, kernel_, shown_),
          presort_(scene, candidate, reference, kernel_),
          look_(scene, candidate, reference) {
        if (wanted.histograms) histograms_.emplace();
        if (wanted.errors)
            scribes_.emplace(Scribes{{candidate_, triangle_count_, wanted.errors->candidate},
                                     {reference_, triangle_count_, wanted.errors->reference}});
    }

    Comparison(const Comparison&) = delete;  // its laws look into what it has seen

    /// Compares the pixels of a tile.
    void compare(const PixelBox& tile, OpenTiles& open) {
        shown_.clear();
        opened_ = {};
        std::size_t runs = 0;
        const bool is_last = tile.right == candidate_.view().width;
        for (int y = tile.top; y < tile.bottom; ++y) {
            Strip& strip = strips_[std::size_t(y - tile.top)];
            strip.x = tile.left, strip.y = y;
            look_at(strip.candidate, candidate_, tile, y, ragged_.candidate);
            look_at(strip.reference, reference_, tile, y, ragged_.reference);
            const strips::Ids ids = kernel_.compare(strip.candidate.primitive, strip.reference.primitive);
            strip.turns = ids.turns, strip.differ = ids.differ;
            runs += std::size_t(ids.runs);
            if (!is_last) fetch_ahead(strip.candidate.primitive);
        }
        turn_to(tile, runs);
        Presort::Largest largest{known(candidate_largest_, largest_.candidate),
                                 known(reference_largest_, largest_.reference)};
        for (int y = tile.top; y < tile.bottom; ++y) {
            Strip& strip = strips_[std::size_t(y - tile.top)];
            if (!is_last) fetch_ahead(strip.reference.primitive);
            if (way_ == Way::by_corners && y + 1 < tile.bottom)
                find_runs(strips_[std::size_t(y + 1 - tile.top)]);
            sort(strip, largest);
            if (!is_last) fetch_ahead(strip.candidate.camera_depth);
            if (sorted_.sorted != SortedStrip::all_sorted) hold(strip);
            if (scribes_) {
                const auto width = std::size_t(tile.right - tile.left);
                scribes_->candidate.write(strip.candidate, sorted_.ratio.candidate, {strip.x, y, width});
                scribes_->reference.write(strip.reference, sorted_.ratio.reference, {strip.x, y, width});
            }
            settle(strip, std::size_t(y - tile.top));
            if (!is_last) fetch_ahead(strip.reference.camera_depth);
        }
        tell(tile, open);
        raise(candidate_largest_, largest.candidate);
        raise(reference_largest_, largest.reference);
        tell(candidate_largest_, largest_.candidate);
        tell(reference_largest_, largest_.reference);
    }

    Tally tally() const {
        Tally all = one_by_one_;
        raise(all.candidate, std::ranges::max(candidate_largest_));
        raise(all.reference, std::ranges::max(reference_largest_));
        if (histograms_) histograms_->add_to(all);
        return all;
    }

  private:
    /// Strips that reach beyond the image's right side, filled up: there both frames are bare.
    struct Ragged {
        std::array<Strip::Values<PrimitiveId>, tile_height> primitive;
        std::array<Strip::Values<float>, tile_height> camera_depth;
    };
    static void look_at(Strip::Side& side, const Witness& witness, const PixelBox& tile, int y,
                        Ragged& ragged) {
        const auto left = std::size_t(tile.left), width = std::size_t(tile.right - tile.left);
        const auto look = [&](const auto& plane, auto& filled, auto beyond) -> const auto* {
            const auto* const shown = &plane.row(y)[left];
            if (width == Strip::width) return shown;
            std::fill(std::copy_n(shown, width, filled.begin()), filled.end(), beyond);
            return &filled[0];
        };
        const auto row = std::size_t(y - tile.top);
        side.primitive = look(witness.frame().primitive, ragged.primitive[row], PrimitiveId::none);
        side.camera_depth = look(witness.frame().camera_depth, ragged.camera_depth[row], background_depth);
    }

    /// How the pixels of a tile are asked about at first.
    enum class Way {
        in_full,       ///< each against the whole formula
        by_tolerance,  ///< each triangle has one
        by_corners,    ///< each run by itself
    };

    void turn_to(const PixelBox& tile, std::size_t runs) {
        const std::span rows(strips_.data(), std::size_t(tile.bottom - tile.top));
        way_ = Way::in_full;
        if (!histograms_ && !scribes_ && presort_.knows_corners() &&
            runs > many_runs_of_strip * rows.size() && are_mostly_new(rows)) {
            way_ = Way::by_corners;
            presort_.turn_to_unknown();
            for (const Strip& strip : rows) fetch_triangles(scene_, strip);
            find_runs(rows[0]);
            return;
        }
        for (Strip& strip : rows) laws_.look_up(strip);
        if (histograms_ || scribes_ || shown_.count() > many_laws) return;
        way_ = Way::by_tolerance;
        presort_.turn_to(tile, shown_);
    }

    /// Are many runs of triangles that the strip above does not show there? A sample says.
    bool are_mostly_new(std::span<const Strip> rows) const {
        int runs = 0, new_runs = 0;
        for (std::size_t i = 3; i < rows.size(); i += 4) {
            const strips::Ids downwards =
                kernel_.compare(rows[i].candidate.primitive, rows[i - 1].candidate.primitive);
            runs += downwards.runs;
            new_runs += std::popcount(downwards.turns & downwards.differ);
        }
        return new_runs * 5 > runs * 2;
    }

    void sort(Strip& strip, Presort::Largest& largest) {
        sorted_.sorted = 0;
        if (way_ == Way::by_tolerance) presort_.sort(shown_, largest, strip, sorted_);
        if (way_ != Way::by_corners) return;
        const Strip::Pixels certain = presort_.certain_by_corners(largest, strip, runs_of(strip));
        if (certain != Strip::all) laws_.look_up_around(strip, ~certain);
        presort_.sort_others(shown_, largest, strip, certain, sorted_);
    }

    strips::Runs& runs_of(const Strip& strip) { return runs_[std::size_t(strip.y) % runs_.size()]; }
    void find_runs(const Strip& strip) { set_runs(scene_, strip, runs_of(strip)); }

    void record(BoundRecord& of, double error_over_bound) const {
        histograms_ ? count(of, error_over_bound) : raise(of, error_over_bound);
    }
    static void raise(BoundRecord& record, double error_over_bound) {
        record.max_error_over_bound = std::max(record.max_error_over_bound, error_over_bound);
    }

    /// The largest ratio, here or anywhere.
    static double known(const Largest& here, const std::atomic<double>& anywhere) {
        return std::max(std::ranges::max(here), anywhere.load(std::memory_order_relaxed));
    }
    static void raise(Largest& here, double largest) { here[0] = std::max(here[0], largest); }

    /// Two threads may overwrite each other's; then less is known.
    static void tell(const Largest& here, std::atomic<double>& anywhere) {
        const double largest = std::ranges::max(here);
        if (largest > anywhere.load(std::memory_order_relaxed))
            anywhere.store(largest, std::memory_order_relaxed);
    }

    void hold(const Strip& strip) {
        const bool perspective = candidate_.projection() == Projection::perspective;
        (perspective ? hold_perspective : hold_parallel)(shown_.laws(), strip, laws_along(strip), sorted_);
    }

    void settle(const Strip& strip, std::size_t row) {
        if (sorted_.sorted != SortedStrip::all_sorted)
            sort_out(strip, sorted_, candidate_largest_, reference_largest_);
        if (histograms_) histograms_->add(strip, sorted_.ratio);
        for (std::size_t chunk = 0; chunk < sorted_.open.size(); ++chunk) {
            if (sorted_.open[chunk] == 0) continue;
            const ColumnMask differ = Strip::in_chunk(strip.differ, chunk * Strip::chunk);
            const ColumnMask open = still_open(strip, chunk, differ);
            opened_[chunk].pixels[row] = std::uint16_t(open);
            opened_[chunk].differ[row] = std::uint16_t(open & differ);
            opened_[chunk].lawful[row] = std::uint16_t(open & sorted_.lawful[chunk]);
        }
    }

    ColumnMask still_open(const Strip& strip, std::size_t chunk, ColumnMask differ) {
        ColumnMask open = sorted_.open[chunk];
        for (ColumnMask rest = open & ~differ; rest != 0; rest &= rest - 1) {
            const std::size_t i = chunk * Strip::chunk + std::size_t(std::countr_zero(rest));
            if (settles({strip.x + int(i), strip.y}, sorted_.ratio.reference[i])) open &= ~(rest & -rest);
        }
        return open;
    }

    void tell(const PixelBox& tile, OpenTiles& open) const {
        for (std::size_t chunk = 0; chunk < opened_.size(); ++chunk) {
            const auto& [pixels, differ, lawful] = opened_[chunk];
            const OpenTiles::Opened opened{TileMask::of(pixels), TileMask::of(differ), TileMask::of(lawful)};
            if (!opened.pixels.is_none())
                open.open(tile.left / Tiles::side_px + int(chunk), tile.top / Tiles::side_px, opened);
        }
    }

    /// A pixel at which both name the same triangle, or none.
    bool settles(const PixelPlace& place, double known_reference_ratio) {
        const OpenPixel pixel = look_.at(place.x, place.y, known_reference_ratio);
        const bool is_bare = pixel.finding.candidate.primitive == PrimitiveId::none;
        if (!is_bare && !pixel.candidate_invalid && !pixel.reference_invalid) {
            record(one_by_one_.candidate, pixel.finding.error_over_bound);
            record(one_by_one_.reference, pixel.reference_error_over_bound);
        }
        return is_settled(pixel);
    }

    struct Scribes {
        ErrorScribe candidate, reference;
    };

    ShownTriangles shown_;
    const Scene& scene_;
    std::size_t triangle_count_;
    const Witness &candidate_, &reference_;
    LargestSoFar& largest_;
    const strips::Kernel& kernel_;
    StripLaws laws_;
    Presort presort_;
    std::array<strips::Runs, 2> runs_;  ///< of the strip at hand and the next one, by y
    std::array<Strip, tile_height> strips_;
    SortedStrip sorted_;  ///< the strip at hand
    /// Of those tiles in which open pixels wait: by row, bit i is column i.
    struct Opened {
        std::array<std::uint16_t, TileMask::rows> pixels{}, differ{}, lawful{};
    };
    std::array<Opened, Strip::width / Strip::chunk> opened_;
    Largest candidate_largest_{}, reference_largest_{};
    Tally one_by_one_;
    PixelLook look_;
    std::optional<Scribes> scribes_;
    std::optional<DepthHistograms> histograms_;
    struct {
        Ragged candidate, reference;
    } ragged_;
    Way way_ = Way::in_full;  ///< of the tile: histograms and maps of errors want every ratio
};

}  // namespace

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

Tally compare_frames(const Scene& scene, const Witness& candidate, const Witness& reference,
                     const Wanted& wanted, OpenTiles& open) {
    LargestSoFar largest;
    tbb::enumerable_thread_specific<Comparison> comparisons(
        [&] { return Comparison(scene, candidate, reference, wanted, largest); });
    const Resolution size = candidate.frame().size();
    const auto compare_row = [&](int row) {
        const int top = row * tile_height, bottom = std::min(top + tile_height, size.height);
        Comparison& comparison = comparisons.local();
        for (int left = 0; left < size.width; left += tile_width)
            comparison.compare({left, top, std::min(left + tile_width, size.width), bottom}, open);
    };
    tbb::parallel_for(0, (size.height + tile_height - 1) / tile_height, compare_row);
    Tally sum;
    for (const Comparison& comparison : comparisons) add(sum, comparison.tally());
    return sum;
}

}  // namespace zproof
