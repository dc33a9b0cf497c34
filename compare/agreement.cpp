#include "compare/agreement.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace zproof {

namespace {

/// The triangle asked for last: neighbouring pixels, and both witnesses, mostly ask for the same.
class TriangleClerk {
  public:
    explicit TriangleClerk(const Witness& any_witness) : witness_(any_witness) {}

    const TriangleInView& triangle(PrimitiveId primitive) {
        if (!triangle_ || primitive != primitive_) triangle_.emplace(witness_.triangle_in_view(primitive));
        primitive_ = primitive;
        return *triangle_;
    }

  private:
    const Witness& witness_;
    PrimitiveId primitive_ = PrimitiveId::none;
    std::optional<TriangleInView> triangle_;
};

/// Holds one witness's answers against their bounds.
class DepthClerk {
  public:
    DepthClerk(const Witness& witness, TriangleClerk& triangles) : witness_(witness), triangles_(triangles) {}

    /// The answer must be valid; background has no depth to be held.
    std::optional<DepthCheck> check(const Answer& answer, int x, int y) {
        if (answer.primitive == PrimitiveId::none) return std::nullopt;
        return witness_.check(depth(answer.primitive), answer, x, y);
    }
    const TriangleDepth& depth(PrimitiveId primitive) {
        if (!depth_ || primitive != primitive_)
            depth_.emplace(depth_of(triangles_.triangle(primitive), witness_.bounds()));
        primitive_ = primitive;
        return *depth_;
    }

  private:
    const Witness& witness_;
    TriangleClerk& triangles_;
    PrimitiveId primitive_ = PrimitiveId::none;
    std::optional<TriangleDepth> depth_;
};

/// A row's, or a pixel's, look at both witnesses.
class Comparison {
  public:
    Comparison(const Scene& scene, const Witness& candidate, const Witness& reference)
        : triangle_count_(scene.triangles.size()),
          candidate_(candidate),
          reference_(reference),
          triangles_(candidate),
          candidate_clerk_(candidate, triangles_),
          reference_clerk_(reference, triangles_) {}

    /// The way of most pixels: both say the same, and double precision is enough to hold both depths lawful.
    /// Counts them then.
    bool settles_at_once(int x, int y, Tally& tally) {
        const Answer ours = candidate_.answer_at(x, y), theirs = reference_.answer_at(x, y);
        if (ours.primitive != theirs.primitive) return false;
        if (ours.primitive == PrimitiveId::none)
            return ours.camera_depth == background_depth && theirs.camera_depth == background_depth;
        if (std::size_t(ours.primitive) >= triangle_count_) return false;
        const TriangleDepth &our_depth = candidate_clerk_.depth(ours.primitive),
                            &their_depth = reference_clerk_.depth(theirs.primitive);
        const DepthBound our_bound = our_depth.at(x, y), their_bound = their_depth.at(x, y);
        if (!our_depth.certainly_holds(our_bound, ours.camera_depth) ||
            !their_depth.certainly_holds(their_bound, theirs.camera_depth))
            return false;
        count(tally.candidate, error_over_bound(our_bound, ours.camera_depth));
        count(tally.reference, error_over_bound(their_bound, theirs.camera_depth));
        return true;
    }

    OpenPixel look_at(int x, int y) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        OpenPixel open;
        Finding& f = open.finding;
        f = {x,
             y,
             PixelClass::agree,
             candidate_.answer_at(x, y),
             reference_.answer_at(x, y),
             0,
             {nan, nan, nan},
             nan};
        open.candidate_invalid = is_invalid(f.candidate, triangle_count_);
        open.reference_invalid = is_invalid(f.reference, triangle_count_);
        if (!open.candidate_invalid)
            if (const auto check = candidate_clerk_.check(f.candidate, x, y)) {
                f.candidate_depth = check->bound;
                f.error_over_bound = check->error_over_bound;
                open.candidate_depth_lawful = check->lawful;
            }
        if (!open.reference_invalid)
            if (const auto check = reference_clerk_.check(f.reference, x, y)) {
                reference_error_over_bound_ = check->error_over_bound;
                open.reference_depth_lawful = check->lawful;
            }
        return open;
    }
    double reference_error_over_bound() const { return reference_error_over_bound_; }

  private:
    std::size_t triangle_count_;
    const Witness &candidate_, &reference_;
    TriangleClerk triangles_;
    DepthClerk candidate_clerk_, reference_clerk_;
    double reference_error_over_bound_ = 0;
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

std::vector<OpenPixel> open_pixels(const Scene& scene, const View& view, const Witness& candidate,
                                   const Witness& reference, int y, Tally& tally) {
    std::vector<OpenPixel> open;
    Comparison comparison(scene, candidate, reference);
    for (int x = 0; x < view.width; ++x) {
        if (comparison.settles_at_once(x, y, tally)) continue;
        const OpenPixel pixel = comparison.look_at(x, y);
        const Finding& f = pixel.finding;
        if (f.candidate.primitive == f.reference.primitive && f.candidate.primitive != PrimitiveId::none &&
            !pixel.candidate_invalid && !pixel.reference_invalid) {
            count(tally.candidate, f.error_over_bound);
            count(tally.reference, comparison.reference_error_over_bound());
        }
        if (!is_settled(pixel)) open.push_back(pixel);
    }
    return open;
}

OpenPixel open_pixel(const Scene& scene, const Witness& candidate, const Witness& reference, int x, int y) {
    return Comparison(scene, candidate, reference).look_at(x, y);
}

}  // namespace zproof
