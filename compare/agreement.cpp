#include "compare/agreement.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "compare/memory.h"

namespace zproof {

namespace {

constexpr int tile_width = 64;

/// What both witnesses may say of one triangle's depth.
struct DepthOfBoth {
    TriangleDepth candidate, reference;
};

/// A tile seldom shows more triangles.
constexpr std::size_t remembered_triangles = 512;

/// Pixels [begin, end) of a row at which both name the same triangle, or both none; one pixel where they
/// differ.
struct Run {
    PrimitiveId candidate, reference;
    int begin, end;
};

Run run_at(std::span<const PrimitiveId> candidate, std::span<const PrimitiveId> reference, int begin,
           int limit) {
    const auto at = [](std::span<const PrimitiveId> row, int x) { return row[std::size_t(x)]; };
    Run run{at(candidate, begin), at(reference, begin), begin, begin + 1};
    if (run.candidate != run.reference) return run;
    while (run.end < limit && at(candidate, run.end) == run.candidate &&
           at(reference, run.end) == run.candidate)
        ++run.end;
    return run;
}

/// A record in the making. Neighbouring pixels often fall into one bin: they are counted side by side.
class Count {
  public:
    void add(std::span<const double> error_over_bound) {
        for (std::size_t i = 0; i < error_over_bound.size(); ++i) {
            const double bin = std::min(error_over_bound[i] * 20, 20.0);
            ++bins_[i % lanes][bin >= 0 ? std::size_t(int(bin)) : 20];
            most_ = std::max(most_, error_over_bound[i]);
        }
    }
    void add_to(BoundRecord& record) const {
        record.max_error_over_bound = std::max(record.max_error_over_bound, most_);
        for (const BoundHistogram& bins : bins_)
            for (std::size_t i = 0; i < bins.size(); ++i) record.histogram[i] += bins[i];
    }

  private:
    static constexpr std::size_t lanes = 4;
    std::array<BoundHistogram, lanes> bins_{};
    double most_ = 0;
};

/// A look at both witnesses, tile by tile or at one pixel.
class Comparison {
  public:
    Comparison(const Scene& scene, const Witness& candidate, const Witness& reference)
        : triangle_count_(scene.triangles.size()),
          candidate_(candidate),
          reference_(reference),
          triangles_(remembered_triangles) {}

    /// Compares pixels [left, right) of a row.
    void compare(int left, int right, int y, Findings& found) {
        const Frame &ours = candidate_.frame(), &theirs = reference_.frame();
        for (int x = left; x < right;) {
            const Run run = run_at(ours.primitive.row(y), theirs.primitive.row(y), x, right);
            compare(run, y, found);
            x = run.end;
        }
    }

    /// Adds what was counted at pixels that double precision settled.
    void add_to(Tally& tally) const {
        candidate_count_.add_to(tally.candidate);
        reference_count_.add_to(tally.reference);
    }

    OpenPixel look_at(int x, int y) {
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
        if (!open.reference_invalid && f.reference.primitive != PrimitiveId::none) {
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

    void compare(const Run& run, int y, Findings& found) {
        if (run.candidate != run.reference)
            found.open.push_back(look_at(run.begin, y));
        else if (run.candidate == PrimitiveId::none)
            compare_bare(run, y, found);
        else if (std::size_t(run.candidate) < triangle_count_)
            compare_depths(run, y, found);
        else
            for (int x = run.begin; x < run.end; ++x) found.open.push_back(look_at(x, y));
    }

    void compare_bare(const Run& run, int y, Findings& found) {
        for (int x = run.begin; x < run.end; ++x)
            if (candidate_.answer_at(x, y).camera_depth != background_depth ||
                reference_.answer_at(x, y).camera_depth != background_depth)
                found.open.push_back(look_at(x, y));
    }

    void compare_depths(const Run& run, int y, Findings& found) {
        const auto count_of_run = std::size_t(run.end - run.begin);
        const auto depths = [&](const Witness& witness) {
            return witness.frame().camera_depth.row(y).subspan(std::size_t(run.begin), count_of_run);
        };
        std::array<double, tile_width> ours, theirs;  // filled by hold()
        const DepthOfBoth& triangle = depth_of_both(run.candidate);
        triangle.candidate.hold(run.begin, y, depths(candidate_), ours.data());
        triangle.reference.hold(run.begin, y, depths(reference_), theirs.data());
        std::size_t settled = 0;
        for (std::size_t i = 0; i < count_of_run; ++i)
            if (ours[i] == unsettled || theirs[i] == unsettled) {
                settle(look_at(run.begin + int(i), y), found);
            } else {
                ours[settled] = ours[i];
                theirs[settled++] = theirs[i];
            }
        candidate_count_.add(std::span(ours).first(settled));
        reference_count_.add(std::span(theirs).first(settled));
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
    Count candidate_count_, reference_count_;
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
    for (int left = 0; left < view.width; left += tile_width)
        for (int y = top; y < bottom; ++y)
            comparison.compare(left, std::min(left + tile_width, view.width), y, rows[std::size_t(y - top)]);
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
