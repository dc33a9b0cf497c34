#include "compare/agree/agree.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

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

/// One thread's look at both frames, block by block.
class BlockScan {
  public:
    BlockScan(const FramePair& frames, ErrorMaps* errors)
        : frames_(frames), triangle_count_(frames.scene.triangles.size()), table_(frames), errors_(errors) {}

    void scan(int left, int top, std::vector<UndecidedPixel>& undecided) {
        const int right = std::min(left + block_width, frames_.view.width),
                  bottom = std::min(top + block_height, frames_.view.height);
        table_.clear();
        for (int y = top; y < bottom; ++y) {
            const PixelRow row{left, right, y};
            const auto candidate = row.of(frames_.candidate.frame.primitive),
                       reference = row.of(frames_.reference.frame.primitive);
            look_up(candidate);
            if (!std::ranges::equal(candidate, reference)) look_up(reference);
        }
        table_.make();
        for (int y = top; y < bottom; ++y) scan({left, right, y}, undecided);
    }

    const RowCounts& counts() const { return counts_; }

  private:
    bool is_triangle(PrimitiveId id) const { return std::size_t(id) < triangle_count_; }

    /// Calls visit(id, first, end) for each run of pixels that show the same.
    template <class Visit>
    static void for_each_run(std::span<const PrimitiveId> ids, const Visit& visit) {
        for (std::size_t first = 0; first < ids.size();) {
            std::size_t end = first + 1;
            while (end < ids.size() && ids[end] == ids[first]) ++end;
            visit(ids[first], first, end);
            first = end;
        }
    }

    void look_up(std::span<const PrimitiveId> ids) {
        for_each_run(ids, [&](PrimitiveId id, std::size_t, std::size_t) {
            if (is_triangle(id)) table_.place_of(id);
        });
    }

    /// What one frame shows, with error / bound; a background that is none and what is no triangle are
    /// undecided.
    void look_at(const PixelRow& row, const Frame& frame, TriangleDepth BoundTable::Depths::*side,
                 RowOf<PrimitiveId>& shown, RowOf<double>& errors) {
        const auto ids = row.of(frame.primitive);
        std::fill(std::ranges::copy(ids, shown.begin()).out, shown.end(), PrimitiveId::none);
        std::ranges::copy(row.of(frame.camera_depth), depths_.begin());
        for_each_run(ids, [&](PrimitiveId id, std::size_t first, std::size_t end) {
            if (is_triangle(id))
                find_depth_errors(table_[table_.place_of(id)].*side, row.left + int(first), row.y,
                                  end - first, &depths_[first], &errors_found_[first]);
            else
                for (std::size_t i = first; i < end; ++i)
                    errors_found_[i] =
                        id == PrimitiveId::none && depths_[i] == background_depth ? 0 : undecided_error;
        });
        std::fill(std::copy_n(errors_found_.begin(), ids.size(), errors.begin()), errors.end(), 0.0);
    }

    void scan(const PixelRow& row, std::vector<UndecidedPixel>& undecided) {
        look_at(row, frames_.candidate.frame, &BoundTable::Depths::candidate, row_.candidate,
                row_.candidate_error);
        look_at(row, frames_.reference.frame, &BoundTable::Depths::reference, row_.reference,
                row_.reference_error);
        if (counts_.add(row_)) list_undecided(row, undecided);
        if (!errors_) return;
        write_errors(row, frames_.candidate.frame, &BoundTable::Depths::candidate, row_.candidate_error,
                     errors_->candidate);
        write_errors(row, frames_.reference.frame, &BoundTable::Depths::reference, row_.reference_error,
                     errors_->reference);
    }

    void list_undecided(const PixelRow& row, std::vector<UndecidedPixel>& undecided) const {
        for (std::size_t i = 0; i < row.count(); ++i) {
            const bool are_decided = row_.candidate_error[i] >= 0 && row_.reference_error[i] >= 0;
            if (!are_decided || row_.candidate[i] != row_.reference[i])
                undecided.push_back({{row.left + int(i), row.y}, are_decided});
        }
    }

    /// What is undecided has an error as well.
    void write_errors(const PixelRow& row, const Frame& frame, TriangleDepth BoundTable::Depths::*side,
                      const RowOf<double>& errors, Plane<float>& map) {
        const auto ids = row.of(frame.primitive);
        const auto depths = row.of(frame.camera_depth);
        for (std::size_t i = 0; i < row.count(); ++i) {
            const int x = row.left + int(i);
            double error = std::numeric_limits<double>::quiet_NaN();
            if (is_triangle(ids[i]) && errors[i] != undecided_error)
                error = errors[i];
            else if (is_triangle(ids[i]))
                error = error_over_bound((table_[table_.place_of(ids[i])].*side).at(x, row.y), depths[i]);
            map.at(x, row.y) = float(error);
        }
    }

    const FramePair& frames_;
    std::size_t triangle_count_;
    BoundTable table_;
    ErrorMaps* errors_;
    ComparedRow row_;
    /// Of one frame's row; runs are read and written beyond their ends, from left to right.
    std::array<float, row_pixels + errors_together> depths_{};
    std::array<double, row_pixels + errors_together> errors_found_{};
    RowCounts counts_;
};

}  // namespace

Agreement find_agreement(const FramePair& frames, ErrorMaps* errors) {
    const int bands = (frames.view.height + block_height - 1) / block_height;
    tbb::enumerable_thread_specific<BlockScan> scans([&] { return BlockScan(frames, errors); });
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
