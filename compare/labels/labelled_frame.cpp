#include "compare/labels/labelled_frame.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>

#include "compare/adjudicate/adjudicator.h"
#include "compare/adjudicate/pixel_check.h"
#include "compare/adjudicate/tile_work.h"
#include "compare/adjudicate/unproven_pixels.h"
#include "compare/admissible/depth_rule.h"
#include "compare/labels/search_reach.h"

namespace zproof {

namespace {

bool is_background(const TriangleLabels& labels, std::uint32_t label, float depth) {
    if (labels.are_absent) return depth == background_depth;
    return std::ranges::count(labels.background, label) > 0;
}

/// A triangle of the pixel's label, held against the pixel's depth.
struct DepthFit {
    PrimitiveId triangle = PrimitiveId::none;
    bool is_within_bound = false;
    double error = 0;

    bool operator<(const DepthFit& other) const {
        return std::tuple{!is_within_bound, error, triangle} <
               std::tuple{!other.is_within_bound, other.error, other.triangle};
    }
};

/// Each label with its first triangle, ascending.
class FirstTriangles {
  public:
    explicit FirstTriangles(std::span<const std::uint32_t> of_triangle) {
        for (std::size_t t = 0; t < of_triangle.size(); ++t)
            if (t == 0 || of_triangle[t] != of_triangle[t - 1])
                first_.push_back({of_triangle[t], std::uint32_t(t)});
        std::ranges::sort(first_);
        const auto same_label = [](const auto& a, const auto& b) { return a.first == b.first; };
        first_.erase(std::unique(first_.begin(), first_.end(), same_label), first_.end());
    }

    PrimitiveId of(std::uint32_t label) const {
        const auto found = std::ranges::lower_bound(first_, label, {}, [](const auto& p) { return p.first; });
        return found == first_.end() || found->first != label ? no_such_triangle : PrimitiveId(found->second);
    }

  private:
    std::vector<std::pair<std::uint32_t, std::uint32_t>> first_;
};

/// One frame of labels being turned into triangles.
class LabelledFrame {
  public:
    LabelledFrame(const Scene& scene, const View& view, const RenderedFrame& of_labels,
                  const TriangleLabels& labels, const RenderedFrame& reference)
        : scene_(scene),
          view_(view),
          labelled_(view, of_labels),
          labels_(labels),
          reference_(reference.frame),
          is_unproven_(unproven_by(reference)),
          first_(labels.of_triangle) {}

    Frame triangles() const {
        Frame frame = labelled_.frame;
        std::vector<std::vector<PixelCoord>> open_in_row(std::size_t(view_.height));
        tbb::parallel_for(0, view_.height,
                          [&](int y) { name_in_row(y, frame, open_in_row[std::size_t(y)]); });
        std::vector<PixelCoord> open;
        for (const auto& pixels : open_in_row) open.insert(open.end(), pixels.begin(), pixels.end());
        search_at(open, frame);
        return frame;
    }

  private:
    /// Where it would prove nothing that the candidate names the reference's triangle.
    Plane<std::uint8_t> unproven_by(const RenderedFrame& reference) const {
        Frame supposed;
        supposed.primitive =
            Plane<PrimitiveId>::lent(reference_.size(), reference_.primitive.pixels().data());
        supposed.camera_depth =
            Plane<float>::lent(reference_.size(), labelled_.frame.camera_depth.pixels().data());
        return find_unproven_pixels(
            {scene_, view_, {view_, {supposed, labelled_.precision}}, {view_, reference}});
    }

    std::uint32_t label_at(const PixelCoord& pixel) const {
        return labels_.are_absent ? 0 : std::uint32_t(labelled_.frame.primitive.at(pixel.x, pixel.y));
    }

    /// Names what needs no search; lists the other pixels.
    void name_in_row(int y, Frame& frame, std::vector<PixelCoord>& open) const {
        for (int x = 0; x < view_.width; ++x) {
            const PixelCoord pixel{x, y};
            const std::uint32_t label = label_at(pixel);
            const float depth = labelled_.frame.camera_depth.at(x, y);
            PrimitiveId& named = frame.primitive.at(x, y);
            const PrimitiveId first = first_.of(label), reference = reference_.primitive.at(x, y);
            const bool is_proven = !is_unproven_.at(x, y);
            if (is_background(labels_, label, depth) && !may_be_a_triangle(pixel))
                named = PrimitiveId::none;
            else if (first == no_such_triangle || std::isnan(depth))
                named = first;
            else if (is_proven && has_label(reference, label) && holds_depth(reference, pixel))
                name(frame, pixel, reference);
            else
                open.push_back(pixel);
        }
    }

    void name(Frame& frame, const PixelCoord& pixel, PrimitiveId triangle) const {
        frame.primitive.at(pixel.x, pixel.y) = triangle;
        if (triangle != PrimitiveId::none) frame.camera_depth.at(pixel.x, pixel.y) = depth_at(pixel);
    }

    /// What a triangle would have there. What is read as background may be stored as a depth at far is.
    float depth_at(const PixelCoord& pixel) const {
        const float depth = labelled_.frame.camera_depth.at(pixel.x, pixel.y);
        return labels_.is_far_background && depth == background_depth ? float(view_.camera.far_depth) : depth;
    }

    /// Background without an id: is it what a triangle has whose depth is rounded to that of far?
    bool may_be_a_triangle(const PixelCoord& pixel) const {
        const bool is_bare = reference_.primitive.at(pixel.x, pixel.y) == PrimitiveId::none;
        return labels_.are_absent && !labels_.of_triangle.empty() &&
               (!is_bare || is_unproven_.at(pixel.x, pixel.y));
    }

    bool has_label(PrimitiveId triangle, std::uint32_t label) const {
        const auto t = std::size_t(triangle);
        return t < labels_.of_triangle.size() && labels_.of_triangle[t] == label;
    }

    struct DepthOfOne {
        PrimitiveId triangle = PrimitiveId::none;
        CornersWorld p_world{};
        TriangleDepth depth;
    };
    /// Depths of one thread, each where the triangle's id modulo their number says: neighbours ask for the
    /// same.
    using RecentDepths = std::vector<DepthOfOne>;
    static constexpr std::size_t most_recent = 1024;

    bool holds_depth(PrimitiveId triangle, const PixelCoord& pixel) const {
        return check(triangle, pixel).is_admissible;
    }

    const DepthOfOne& depth_of(PrimitiveId triangle) const {
        DepthOfOne& recent = recent_.local()[std::size_t(triangle) % most_recent];
        if (recent.triangle != triangle) {
            const CornersWorld p_world = corners_of(scene_, std::uint32_t(triangle));
            const ViewBounds& shown = labelled_.shown_bounds;
            recent = {triangle, p_world, TriangleDepth(TriangleInView(view_, shown, p_world), shown)};
        }
        return recent;
    }

    DepthCheck check(PrimitiveId triangle, const PixelCoord& pixel) const {
        const DepthOfOne& of = depth_of(triangle);
        return check_depth(view_, labelled_.shown_bounds, of.p_world, of.depth, pixel, depth_at(pixel));
    }

    /// Looks for a triangle among all that come near.
    void search_at(std::span<const PixelCoord> open, Frame& frame) const {
        if (open.empty()) return;
        const SearchReach reach(scene_, view_, labelled_.bounds);
        Adjudicator(scene_, view_, {&labelled_.bounds}, QueryDetail::admissibility)
            .for_each_pixel(open, [&](TileWork& work, std::size_t i, double searched_px) {
                const PixelCoord& pixel = open[i];
                const double reach_px = reach.at(pixel);
                if (reach_px > searched_px) return reach_px;
                PixelSearch search{work, pixel, searched_px,
                                   fits_at(work.triangles_within(reach_px, pixel, labelled_.bounds), pixel),
                                   reach};
                const std::optional<PrimitiveId> named = best_of(search);
                if (named) name(frame, pixel, *named);
                return named ? 0 : search.needed_px;
            });
    }

    /// The triangles of the pixel's label: those whose depth is within its bound first, the nearest depth
    /// first.
    std::vector<DepthFit> fits_at(std::span<const std::uint32_t> near, const PixelCoord& pixel) const {
        std::vector<DepthFit> fits;
        for (const std::uint32_t t : near) {
            if (!has_label(PrimitiveId(t), label_at(pixel))) continue;
            const DepthCheck depth = check(PrimitiveId(t), pixel);
            const double error = depth_at(pixel) - depth.bound.truth;
            fits.push_back({PrimitiveId(t), depth.is_admissible, std::abs(error)});
        }
        std::ranges::sort(fits, std::less());
        return fits;
    }

    /// The search at one pixel.
    struct PixelSearch {
        TileWork& work;
        const PixelCoord& pixel;
        double searched_px;
        std::vector<DepthFit> fits;
        const SearchReach& reach;
        double needed_px = 0;  ///< above 0: a decision needs that reach
    };

    /// The strongest reason for which one of them is admissible; otherwise the first that is hidden, not
    /// outside.
    struct Found {
        PrimitiveId triangle = PrimitiveId::none;
        Admissibility admissibility = Admissibility::outside;
    };

    /// A depth within its bound that lies behind what covers the pixel is hidden there.
    Admissibility decide(PixelSearch& search, const DepthFit& fit) const {
        QueryResult found;
        PixelQuery query{&labelled_.bounds, fit.triangle, search.pixel.x, search.pixel.y};
        if (fit.is_within_bound) query.depth = depth_at(search.pixel);
        search.needed_px = std::max(search.needed_px, search.work.decide(query, search.searched_px, found));
        return query.depth > found.farthest_depth ? Admissibility::hidden : found.decision.admissibility;
    }

    /// The triangle to name, or nothing where a decision must look farther.
    std::optional<PrimitiveId> best_of(PixelSearch& search) const {
        const std::uint32_t label = label_at(search.pixel);
        const bool is_bare =
            is_background(labels_, label, labelled_.frame.camera_depth.at(search.pixel.x, search.pixel.y));
        Found best{is_bare ? PrimitiveId::none : first_.of(label), Admissibility::outside};
        const auto try_fit = [&](const DepthFit& fit) {
            const Admissibility admissibility = decide(search, fit);
            if (is_better(admissibility, best.admissibility)) best = {fit.triangle, admissibility};
        };
        const auto try_all_within = [&](const std::vector<DepthFit>& fits) {
            const auto first_wrong = std::ranges::find(fits, false, &DepthFit::is_within_bound);
            std::for_each(fits.begin(), first_wrong, try_fit);
            return first_wrong;
        };
        if (is_bare && !search.fits.empty() && search.fits.front().is_within_bound)
            try_fit({PrimitiveId::none});
        const auto first_wrong = try_all_within(search.fits);
        if (!is_admissible(best.admissibility))
            try_all_within(fits_at(search.reach.shown_by_rounding(search.pixel), search.pixel));
        if (search.needed_px > 0) return std::nullopt;
        if (is_bare) return is_admissible(best.admissibility) ? best.triangle : PrimitiveId::none;
        if (best.admissibility == Admissibility::outside) {
            const PrimitiveId reference = reference_.primitive.at(search.pixel.x, search.pixel.y);
            if (has_label(reference, label_at(search.pixel)))
                return reference;  // it is said to be at a wrong depth
            for (auto fit = first_wrong; fit != search.fits.end() && !is_admissible(best.admissibility);
                 ++fit)
                try_fit(*fit);
        }
        return search.needed_px > 0 ? std::nullopt : std::optional(best.triangle);
    }

    /// Admissible ones are ordered; one that nobody can decide comes next, then a hidden triangle.
    static bool is_better(Admissibility a, Admissibility b) {
        if (is_admissible(a)) return a < b;
        if (a == Admissibility::undecidable) return is_inadmissible(b);
        return a == Admissibility::hidden && b == Admissibility::outside;
    }

    const Scene& scene_;
    const View& view_;
    BoundedFrame labelled_;
    const TriangleLabels& labels_;
    const Frame& reference_;
    Plane<std::uint8_t> is_unproven_;
    FirstTriangles first_;
    mutable tbb::enumerable_thread_specific<RecentDepths> recent_{RecentDepths(most_recent)};
};

}  // namespace

PrimitiveId label_of(const TriangleLabels& labels, PrimitiveId triangle) {
    const auto t = std::size_t(triangle);
    return t < labels.of_triangle.size() ? PrimitiveId(labels.of_triangle[t]) : PrimitiveId::none;
}

bool have_one_label(const TriangleLabels& labels, PrimitiveId one, PrimitiveId other) {
    const PrimitiveId label = label_of(labels, one);
    return label != PrimitiveId::none && label == label_of(labels, other);
}

Frame with_labels(Frame frame, const TriangleLabels& labels) {
    for (PrimitiveId& id : frame.primitive.pixels())
        if (std::size_t(id) < labels.of_triangle.size())
            id = PrimitiveId(labels.of_triangle[std::size_t(id)]);
    return frame;
}

Frame with_triangles(const Scene& scene, const View& view, const RenderedFrame& of_labels,
                     const TriangleLabels& labels, const RenderedFrame& reference) {
    return LabelledFrame(scene, view, of_labels, labels, reference).triangles();
}

std::string label_sentence(const TriangleLabels& labels, PrimitiveId said) {
    if (labels.are_absent) return "; the frame has no ids: this triangle stands for its depth";
    const auto label = std::uint32_t(said);
    const auto name = labels.names.find(label);
    return "; the frame says " + labels.ids + " " + std::to_string(label) +
           (name == labels.names.end() ? "" : " (" + name->second + ")");
}

}  // namespace zproof
