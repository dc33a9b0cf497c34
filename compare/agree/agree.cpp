#include "compare/agree/agree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include "compare/agree/depth_errors.h"

namespace zproof {

namespace {

/// Pixels that are looked at together: so many share their triangles, whose bounds stay in the cache.
constexpr int block_width = 256, block_height = 32;

/// What a triangle's depth may be by both renderers' bounds, as they show it, and as the candidate compares
/// it.
struct Depths {
    TriangleDepth candidate, reference, compared;
};

/// Pixels [first, end) of a block's row, which show the same: a triangle, or none of the scene's.
struct Run {
    std::size_t first, end;
    const Depths* depths;  ///< null where it is none
};

/// What one frame shows in a block's row, and whose bounds its depths are held against.
struct Look {
    std::span<const PrimitiveId> ids;
    const std::vector<float>& depths;
    const std::vector<Run>& runs;
    TriangleDepth Depths::*bounds;
};

/// Looks at blocks of both frames.
class BlockScan {
  public:
    BlockScan(const FramePair& frames, const Plane<std::uint8_t>& is_unproven, ErrorMaps* maps,
              Agreement& found)
        : frames_(frames),
          is_unproven_(is_unproven),
          maps_(maps),
          found_(found),
          is_in_steps_(frames.candidate.shown_bounds.step_room(0) > 0),
          first_pixel_(frames.view, 0, 0) {
        const std::size_t padded = std::size_t(frames.view.width) + errors_together;
        for (auto* depths : {&candidate_depths_, &reference_depths_}) depths->resize(padded);
        for (auto* errors : {&candidate_errors_, &reference_errors_, &theirs_by_ours_})
            errors->resize(padded);
    }

    void scan_block(int left, int top) {
        of_triangle_.clear();
        const int right = std::min(left + block_width, frames_.view.width),
                  bottom = std::min(top + block_height, frames_.view.height);
        for (int y = top; y < bottom; ++y) scan(y, std::size_t(left), std::size_t(right));
    }

  private:
    /// Pixels [left, right) of a row.
    void scan(int y, std::size_t left, std::size_t right) {
        const Frame &ours = frames_.candidate.frame, &theirs = frames_.reference.frame;
        const auto our_ids = ours.primitive.row(y).first(right),
                   their_ids = theirs.primitive.row(y).first(right);
        const bool are_same = std::ranges::equal(our_ids.subspan(left), their_ids.subspan(left));
        const std::vector<Run> our_runs = runs_in(our_ids, left),
                               their_runs = are_same ? our_runs : runs_in(their_ids, left);
        const auto copy = [&](const Frame& frame, std::vector<float>& depths) {
            std::ranges::copy(frame.camera_depth.row(y).first(right).subspan(left), &depths[left]);
        };
        copy(ours, candidate_depths_);
        copy(theirs, reference_depths_);
        const Look candidate{our_ids, candidate_depths_, our_runs, &Depths::candidate},
            reference{their_ids, reference_depths_, their_runs, &Depths::reference};
        find_errors(candidate, y, candidate_errors_, reference_depths_.data(), theirs_by_ours_.data());
        if (is_in_steps_)  // a step is of what is shown: it puts nothing in front
            find_errors({our_ids, reference_depths_, our_runs, &Depths::compared}, y, theirs_by_ours_);
        find_errors(reference, y, reference_errors_);
        for (const Run& run : their_runs)
            for (std::size_t x = run.first; x < run.end; ++x) record(candidate, reference, run, {int(x), y});
        if (!maps_) return;
        write_map(candidate, candidate_errors_, y, maps_->candidate);
        write_map(reference, reference_errors_, y, maps_->reference);
    }

    std::vector<Run> runs_in(std::span<const PrimitiveId> ids, std::size_t left) {
        std::vector<Run> runs;
        for (std::size_t first = left; first < ids.size(); first = runs.back().end) {
            std::size_t end = first + 1;
            while (end < ids.size() && ids[end] == ids[first]) ++end;
            const bool is_triangle = std::size_t(ids[first]) < frames_.scene.triangles.size();
            runs.push_back({first, end, is_triangle ? &depths_of(ids[first]) : nullptr});
        }
        return runs;
    }

    const Depths& depths_of(PrimitiveId id) {
        const auto [found, is_new] = of_triangle_.try_emplace(id);
        if (is_new) {
            const TriangleInView triangle(first_pixel_, frames_.candidate.bounds,
                                          corners_of(frames_.scene, std::uint32_t(id)));
            Depths& depths = found->second;
            depths.candidate = TriangleDepth(triangle, frames_.candidate.shown_bounds);
            depths.reference = TriangleDepth(triangle, frames_.reference.shown_bounds);
            if (is_in_steps_) depths.compared = TriangleDepth(triangle, frames_.candidate.bounds);
        }
        return found->second;
    }

    /// Error / bound of each depth; a background that is none and what is no triangle are undecided. Other
    /// depths, if any, are held against the same triangles' bounds.
    static void find_errors(const Look& look, int y, std::vector<double>& errors,
                            const float* other_depths = nullptr, double* other_errors = nullptr) {
        for (const auto& [first, end, depths] : look.runs)
            if (depths)
                find_depth_errors(depths->*look.bounds, int(first), y, end - first, &look.depths[first],
                                  &errors[first], other_depths ? other_depths + first : nullptr,
                                  other_errors ? other_errors + first : nullptr);
            else
                for (std::size_t x = first; x < end; ++x)
                    errors[x] = look.ids[x] == PrimitiveId::none && look.depths[x] == background_depth
                                    ? 0
                                    : undecided_error;
    }

    /// Counts the pixel where both frames agree, and lists it where they do not, or where their agreement
    /// proves nothing: the reference may displace its triangle farther than the candidate may, or its depth
    /// is none that the candidate may give.
    void record(const Look& candidate, const Look& reference, const Run& of_reference,
                const PixelCoord& place) {
        const auto x = std::size_t(place.x);
        const double ours = candidate_errors_[x], theirs = reference_errors_[x];
        const bool are_decided = ours >= 0 && theirs >= 0, are_same = candidate.ids[x] == reference.ids[x];
        if (are_decided && are_same && of_reference.depths) {
            count(found_.candidate_depth, ours);
            count(found_.reference_depth, theirs);
        }
        const bool is_another_depth =
            of_reference.depths && (theirs < 0 || (ours >= 0 && theirs_by_ours_[x] < 0));
        const bool is_id_undecided = !are_same || is_another_depth || is_unproven_.at(place.x, place.y) != 0;
        if (!are_decided || is_id_undecided)
            found_.undecided.push_back({place, are_decided, is_id_undecided});
    }

    /// What is undecided has an error as well.
    static void write_map(const Look& look, const std::vector<double>& errors, int y, Plane<float>& map) {
        for (const auto& [first, end, depths] : look.runs)
            for (std::size_t x = first; x < end; ++x) {
                double error = std::numeric_limits<double>::quiet_NaN();
                if (depths && errors[x] >= 0)
                    error = errors[x];
                else if (depths)
                    error = error_over_bound((depths->*look.bounds).at(int(x), y), look.depths[x]);
                map.at(int(x), y) = float(error);
            }
    }

    const FramePair& frames_;
    const Plane<std::uint8_t>& is_unproven_;
    ErrorMaps* maps_;
    Agreement& found_;
    bool is_in_steps_;  ///< the candidate's depths
    ViewRay<double> first_pixel_;
    std::unordered_map<PrimitiveId, Depths> of_triangle_;
    /// Works on one row. Runs are read and written beyond their ends, from left to right.
    std::vector<float> candidate_depths_, reference_depths_;
    std::vector<double> candidate_errors_, reference_errors_;
    std::vector<double>
        theirs_by_ours_;  ///< the reference's depths by the candidate's bounds, where both show the same
};

}  // namespace

Agreement find_agreement(const FramePair& frames, const Plane<std::uint8_t>& is_unproven, ErrorMaps* maps) {
    const int bands = (frames.view.height + block_height - 1) / block_height;
    std::vector<Agreement> of_band(std::size_t(bands), Agreement{});
    tbb::parallel_for(0, bands, [&](int band) {
        Agreement& found = of_band[std::size_t(band)];
        BlockScan scan(frames, is_unproven, maps, found);
        for (int left = 0; left < frames.view.width; left += block_width)
            scan.scan_block(left, band * block_height);
        std::ranges::sort(found.undecided, {}, [](const UndecidedPixel& pixel) {
            return std::pair{pixel.place.y, pixel.place.x};
        });
    });
    Agreement all;
    for (const Agreement& part : of_band) {
        add(all.candidate_depth, part.candidate_depth);
        add(all.reference_depth, part.reference_depth);
        all.undecided.insert(all.undecided.end(), part.undecided.begin(), part.undecided.end());
    }
    return all;
}

}  // namespace zproof
