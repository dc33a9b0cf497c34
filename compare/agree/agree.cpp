#include "compare/agree/agree.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "compare/agree/bound_table.h"
#include "compare/agree/depth_errors.h"
#include "compare/agree/row_counts.h"

namespace zproof {

namespace {

/// Pixels that are looked at together: so many share their triangles.
constexpr int block_width = row_pixels, block_height = 16;

/// Pixels [left, right) of row y.
struct PixelRow {
    int left, right, y;

    std::size_t count() const { return std::size_t(right - left); }
    template <class T>
    std::span<const T> of(const Plane<T>& plane) const {
        return plane.row(y).subspan(std::size_t(left), count());
    }
};

/// Pixels [first, end) of a row, which show the same: a triangle of the table, or none of the scene's.
struct Run {
    std::size_t first, end;
    std::optional<std::uint32_t> place;
};

/// A row's runs in both frames.
struct RowRuns {
    std::vector<Run> of_candidate, of_reference;
    bool are_same = false;  ///< and the reference's are not listed

    const std::vector<Run>& candidate() const { return of_candidate; }
    const std::vector<Run>& reference() const { return are_same ? of_candidate : of_reference; }
};

/// What one frame shows in a row, and by whose bounds.
struct FrameRow {
    const Frame& frame;
    const std::vector<Run>& runs;
    TriangleDepth BoundTable::Depths::*depth;
};

/// One thread's look at both frames, block by block.
class BlockScan {
  public:
    BlockScan(const FramePair& frames, const Plane<std::uint8_t>& unproven, ErrorMaps* errors)
        : frames_(frames),
          triangle_count_(frames.scene.triangles.size()),
          unproven_(unproven),
          table_(frames),
          errors_(errors) {}

    void scan(int left, int top, std::vector<UndecidedPixel>& undecided) {
        const int right = std::min(left + block_width, frames_.view.width),
                  bottom = std::min(top + block_height, frames_.view.height);
        table_.clear();
        for (int y = top; y < bottom; ++y) {
            const PixelRow row{left, right, y};
            const auto candidate = row.of(frames_.candidate.frame.primitive),
                       reference = row.of(frames_.reference.frame.primitive);
            RowRuns& runs = runs_[std::size_t(y - top)];
            list_runs(candidate, runs.of_candidate);
            runs.are_same = std::ranges::equal(candidate, reference);
            if (!runs.are_same) list_runs(reference, runs.of_reference);
        }
        table_.make();
        for (int y = top; y < bottom; ++y) scan({left, right, y}, runs_[std::size_t(y - top)], undecided);
    }

    const RowCounts& counts() const { return counts_; }

  private:
    void list_runs(std::span<const PrimitiveId> ids, std::vector<Run>& runs) {
        runs.clear();
        for (std::size_t first = 0; first < ids.size();) {
            std::size_t end = first + 1;
            while (end < ids.size() && ids[end] == ids[first]) ++end;
            const bool is_triangle = std::size_t(ids[first]) < triangle_count_;
            runs.push_back(
                {first, end, is_triangle ? std::optional(table_.place_of(ids[first])) : std::nullopt});
            first = end;
        }
    }

    /// What one frame shows, with error / bound; a background that is none and what is no triangle are
    /// undecided.
    void look_at(const PixelRow& row, const FrameRow& of, RowOf<PrimitiveId>& shown, RowOf<double>& errors) {
        const auto ids = row.of(of.frame.primitive);
        std::fill(std::ranges::copy(ids, shown.begin()).out, shown.end(), PrimitiveId::none);
        std::ranges::copy(row.of(of.frame.camera_depth), depths_.begin());
        for (const auto& [first, end, place] : of.runs)
            if (place)
                find_depth_errors(table_[*place].*of.depth, row.left + int(first), row.y, end - first,
                                  &depths_[first], &errors_found_[first], &rooms_[first]);
            else
                for (std::size_t i = first; i < end; ++i)
                    errors_found_[i] =
                        ids[i] == PrimitiveId::none && depths_[i] == background_depth ? 0 : undecided_error;
        std::fill(std::copy_n(errors_found_.begin(), ids.size(), errors.begin()), errors.end(), 0.0);
    }

    /// Do both frames show nothing but background?
    bool is_bare(const PixelRow& row, const RowRuns& runs) const {
        const auto is_background = [](float depth) { return depth == background_depth; };
        return runs.are_same && runs.of_candidate.size() == 1 &&
               std::ranges::count(row.of(unproven_), 1) == 0 &&
               row.of(frames_.candidate.frame.primitive).front() == PrimitiveId::none &&
               std::ranges::all_of(row.of(frames_.candidate.frame.camera_depth), is_background) &&
               std::ranges::all_of(row.of(frames_.reference.frame.camera_depth), is_background);
    }

    void scan(const PixelRow& row, const RowRuns& runs, std::vector<UndecidedPixel>& undecided) {
        if (!errors_ && is_bare(row, runs)) return;
        const FrameRow candidate{frames_.candidate.frame, runs.candidate(), &BoundTable::Depths::candidate},
            reference{frames_.reference.frame, runs.reference(), &BoundTable::Depths::reference};
        look_at(row, reference, row_.reference, row_.reference_error);
        look_at(row, candidate, row_.candidate, row_.candidate_error);
        const bool is_any_unproven = find_unproven(row, runs.reference());
        if (counts_.add(row_) || is_any_unproven) list_undecided(row, undecided);
        if (!errors_) return;
        write_errors(row, candidate, row_.candidate_error, errors_->candidate);
        write_errors(row, reference, row_.reference_error, errors_->reference);
    }

    void list_undecided(const PixelRow& row, std::vector<UndecidedPixel>& undecided) const {
        for (std::size_t i = 0; i < row.count(); ++i) {
            const bool are_decided = row_.candidate_error[i] >= 0 && row_.reference_error[i] >= 0;
            const bool is_id_undecided = row_.candidate[i] != row_.reference[i] || is_unproven_[i] != 0;
            if (!are_decided || is_id_undecided)
                undecided.push_back({{row.left + int(i), row.y}, are_decided, is_id_undecided});
        }
    }

    /// Lists the pixels of a row that show the same in both, where the reference does not prove it: it may
    /// displace a triangle farther there than the candidate may, or its depth is none that the candidate may
    /// give. Is there any? The candidate must have been looked at last.
    bool find_unproven(const PixelRow& row, const std::vector<Run>& runs) {
        const auto ours = row.of(frames_.candidate.frame.camera_depth),
                   theirs = row.of(frames_.reference.frame.camera_depth);
        std::ranges::copy(row.of(unproven_), is_unproven_.begin());
        for (const auto& [first, end, place] : runs) {
            bool is_near = true;
            for (std::size_t i = first; i < end; ++i)
                is_near &= std::abs(double(ours[i]) - double(theirs[i])) <= rooms_[i];
            if (!place || is_near) continue;
            std::ranges::copy(theirs.subspan(first, end - first), &depths_[first]);
            find_depth_errors(table_[*place].candidate, row.left + int(first), row.y, end - first,
                              &depths_[first], &errors_found_[first], rooms_there_.data());
            for (std::size_t i = first; i < end; ++i)
                is_unproven_[i] |= std::uint8_t(row_.candidate_error[i] >= 0 && errors_found_[i] < 0);
        }
        return std::ranges::count(std::span(is_unproven_).first(row.count()), 1) > 0;
    }

    /// What is undecided has an error as well.
    void write_errors(const PixelRow& row, const FrameRow& of, const RowOf<double>& errors,
                      Plane<float>& map) {
        const auto depths = row.of(of.frame.camera_depth);
        for (const auto& [first, end, place] : of.runs)
            for (std::size_t i = first; i < end; ++i) {
                const int x = row.left + int(i);
                double error = std::numeric_limits<double>::quiet_NaN();
                if (place && errors[i] >= 0)
                    error = errors[i];
                else if (place)
                    error = error_over_bound((table_[*place].*of.depth).at(x, row.y), depths[i]);
                map.at(x, row.y) = float(error);
            }
    }

    const FramePair& frames_;
    std::size_t triangle_count_;
    const Plane<std::uint8_t>& unproven_;
    BoundTable table_;
    ErrorMaps* errors_;
    std::array<RowRuns, block_height> runs_;  ///< of the block at hand
    ComparedRow row_;
    RowOf<std::uint8_t> is_unproven_{};
    /// The depths of one frame's row; runs are read and written beyond their ends, from left to right.
    std::array<float, row_pixels + errors_together> depths_{};
    std::array<double, row_pixels + errors_together> errors_found_{}, rooms_{}, rooms_there_{};
    RowCounts counts_;
};

}  // namespace

Agreement find_agreement(const FramePair& frames, const Plane<std::uint8_t>& is_unproven, ErrorMaps* errors) {
    const int bands = (frames.view.height + block_height - 1) / block_height;
    tbb::enumerable_thread_specific<BlockScan> scans([&] { return BlockScan(frames, is_unproven, errors); });
    std::vector<std::vector<UndecidedPixel>> of_band;
    of_band.resize(std::size_t(bands));
    tbb::parallel_for(0, bands, [&](int band) {
        BlockScan& scan = scans.local();
        for (int left = 0; left < frames.view.width; left += block_width)
            scan.scan(left, band * block_height, of_band[std::size_t(band)]);
    });
    Agreement all;
    for (const BlockScan& scan : scans) {
        add(all.candidate_depth, scan.counts().candidate());
        add(all.reference_depth, scan.counts().reference());
    }
    for (const auto& pixels : of_band)
        all.undecided.insert(all.undecided.end(), pixels.begin(), pixels.end());
    return all;
}

}  // namespace zproof
