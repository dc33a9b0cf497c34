#include <algorithm>
#include <cmath>

#include "compare/bounds/bounds.h"
#include "frame/number_text.h"
#include "measure/flat.h"
#include "measure/measure.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

/// What the declared precision allows in the probe views, by the judge's own bounds. A grid and a depth
/// buffer are promised by rasterizers alone.
class Allowed {
  public:
    explicit Allowed(const Precision& precision)
        : precision_(precision), raster_(std::get_if<RasterPrecision>(&precision_)) {}
    Allowed(const Allowed&) = delete;

    bool is_raster() const { return raster_ != nullptr; }
    bool is_watertight() const { return zproof::is_watertight(precision_); }
    /// Is a sample on a shared edge one triangle's alone? Integer edge functions have a fill rule; tests that
    /// are closed, or of which nothing is known, meet both triangles and keep one.
    bool has_single_owners() const {
        return raster_ && raster_->edge_functions == EdgeFunctions::exact &&
               raster_->barycentric_tolerance == 0;
    }
    /// The declared grid; nothing where none is.
    std::optional<int> subpixel_bits() const {
        return raster_ && raster_->snap != Snap::none ? std::optional(raster_->subpixel_bits) : std::nullopt;
    }
    Snap snap() const { return raster_->snap; }

    /// How far a vertex may be displaced in the views that look for the grid.
    double displacement_px() const {
        Scene scene;
        add_triangle(scene, Axis::x, {{{0, 0}, {128, 0}, {0, 64}}});
        return BoundsOnPlane(bounds_in(raster_view(128, 64), scene), 0).at(-1).eps_px;
    }
    double depth_of(const DepthStep& step) const {
        const View view = flat_view(step.projection, step.depth, depth_range_of_steps);
        const bool perspective = step.projection == Projection::perspective;
        const LocalBounds local =
            BoundsOnPlane(bounds_of_flat(view), 0).at(perspective ? 1 / step.depth : -step.depth);
        const double per_inverse_depth = perspective ? step.depth * step.depth : 1;
        return local.depth_relative * step.depth + local.depth_absolute +
               (local.inverse_depth_error + std::abs(local.inverse_depth_bias)) * per_inverse_depth;
    }
    double limit_of(const DepthLimit& limit) const {
        const TriangleBounds bounds =
            bounds_of_flat(flat_view(limit.projection, limit.depth, depth_range_of_limits));
        return limit.plane == LimitPlane::near ? bounds.near_slack : bounds.far_slack;
    }

  private:
    TriangleBounds bounds_in(const View& view, const Scene& scene) const {
        return ViewBounds(view, precision_).of(corners_of(scene, 0));
    }
    TriangleBounds bounds_of_flat(const View& view) const {
        Scene scene;
        add_flat(scene, view, 0, Half::left, 0);
        return bounds_in(view, scene);
    }

    Precision precision_;
    const RasterPrecision* raster_;
};

/// The measured is worse where even its better end is.
Conformity conformity_of(bool is_worse) { return is_worse ? Conformity::worse : Conformity::as_declared; }

std::string with_axis(const std::string& name, Axis axis, const char* separator) {
    return name + separator + (axis == Axis::x ? "x" : "y");
}

std::string ties_in_words(TieRounding ties) {
    switch (ties) {
        case TieRounding::to_even:
            return ", ties to even";
        case TieRounding::towards_smaller:
            return ", ties towards the origin";
        case TieRounding::towards_greater:
            return ", ties away from the origin";
        case TieRounding::unclear:
            return ", ties unclear";
    }
    return "";
}

std::string snap_in_words(const SnapGrid& grid) {
    switch (grid.snap) {
        case SnapRounding::nearest:
            return "nearest" + ties_in_words(grid.ties);
        case SnapRounding::towards_smaller:
            return "truncated";
        case SnapRounding::towards_greater:
            return "rounded up";
    }
    return "";
}

class Findings {
  public:
    Findings(const Measurement& m, const Allowed& allowed) : m_(m), allowed_(allowed) {}

    std::vector<Finding> all() && {
        for (const Axis axis : both_axes) add_centre(axis);
        for (const Axis axis : both_axes) add_displacement(axis);
        if (m_.fill) add_fill(*m_.fill);
        if (m_.watertightness) add_watertightness(*m_.watertightness);
        for (const DepthStep& step : m_.depth_steps) add_depth_step(step);
        for (const DepthLimit& limit : m_.depth_limits) add_limit(limit);
        for (const std::string& reason : m_.unmeasured)
            list_.push_back({"unmeasured", "cannot be measured", {}, "", reason, "", Conformity::worse});
        return std::move(list_);
    }

  private:
    void add_centre(Axis axis) {
        const auto& centre = m_.centre_px[std::size_t(axis)];
        if (!centre) return;
        list_.push_back({with_axis("pixel_centre", axis, "_"), with_axis("pixel centre", axis, ", "), centre,
                         "px", "", "0.5", conformity_of(centre->low > 0.5 || centre->high < 0.5)});
    }

    void add_displacement(Axis axis) {
        const auto& found = m_.displacement[std::size_t(axis)];
        if (!found) return;
        add_bits(*found, axis);
        add_shift(*found, axis);
        if (found->grid) add_snap(*found->grid, axis);
    }

    void add_bits(const Displacement& found, Axis axis) {
        Finding f{with_axis("subpixel_bits", axis, "_"),
                  with_axis("sub-pixel bits", axis, ", "),
                  {},
                  "bits",
                  "",
                  "",
                  Conformity::undeclared};
        if (found.grid)
            f.value = Bracket{-std::log2(found.grid->step_px.high), -std::log2(found.grid->step_px.low)};
        else
            f.words = "no grid of " + with_digits(-std::log2(found.finest_px), 6) + " bits or fewer";
        if (const auto declared = allowed_.subpixel_bits()) {
            f.declared = with_digits(*declared, 6);
            f.conformity = conformity_of(f.value && f.value->high < *declared);
        }
        list_.push_back(f);
    }

    void add_shift(const Displacement& found, Axis axis) {
        const auto [low, high] = found.at_least_px;
        const double greatest = std::max(-low, high);
        Finding f{with_axis("vertex_shift", axis, "_"),
                  with_axis("greatest vertex shift seen", axis, ", "),
                  Bracket{greatest, greatest},
                  "px",
                  "from " + with_digits(low, 6) + " to " + with_digits(high, 6),
                  "",
                  Conformity::undeclared};
        if (allowed_.is_raster()) {
            const double most = allowed_.displacement_px();
            f.declared = "<= " + with_digits(most, 6);
            f.conformity = conformity_of(greatest > most);
        }
        list_.push_back(f);
    }

    void add_snap(const SnapGrid& grid, Axis axis) {
        Finding f{
            with_axis("snap", axis, "_"), with_axis("snap", axis, ", "), {}, "", snap_in_words(grid), "",
            Conformity::undeclared};
        if (allowed_.subpixel_bits()) {
            f.declared = allowed_.snap() == Snap::nearest ? "nearest" : "truncated";
            f.conformity =
                conformity_of(allowed_.snap() == Snap::nearest && grid.snap != SnapRounding::nearest);
        }
        list_.push_back(f);
    }

    void add_fill(const FillSides& fill);
    void add_watertightness(const Watertightness& w);
    void add_depth_step(const DepthStep& step);
    void add_limit(const DepthLimit& limit);

    const Measurement& m_;
    const Allowed& allowed_;
    std::vector<Finding> list_;
};

/// "left" where every edge with the triangle to its right in the image owns its centres and no other does.
template <class IsFirst, class IsSecond>
std::string owners(const FillSides& fill, IsFirst is_first, IsSecond is_second, const char* first,
                   const char* second) {
    const auto all = [&](auto is_side, bool owns) {
        return std::ranges::all_of(fill, [&](const FillSide& s) { return !is_side(s) || s.owns == owns; });
    };
    if (all(is_first, true) && all(is_second, false)) return first;
    if (all(is_first, false) && all(is_second, true)) return second;
    if (all(is_first, true) && all(is_second, true)) return std::string{first} + "+" + second;
    if (all(is_first, false) && all(is_second, false)) return std::string{"no "} + first + " or " + second;
    return std::string{"some "} + first + " and " + second;
}

/// The fill rule in words. With the triangle to the right of its direction (y down), an edge that runs up is
/// its left edge and a level one that runs right its top edge.
std::string fill_in_words(const FillSides& fill) {
    const auto left = [](const FillSide& s) { return s.dy < 0; };
    const auto right = [](const FillSide& s) { return s.dy > 0; };
    const auto top = [](const FillSide& s) { return s.dy == 0 && s.dx > 0; };
    const auto bottom = [](const FillSide& s) { return s.dy == 0 && s.dx < 0; };
    return owners(fill, top, bottom, "top", "bottom") + ", " + owners(fill, left, right, "left", "right");
}

/// Every edge has one owner: the triangle on this side or the one on the other.
bool has_single_owners(const FillSides& fill) {
    return std::ranges::all_of(fill, [&](const FillSide& side) {
        const auto is_opposite = [&](const FillSide& s) { return s.dx == -side.dx && s.dy == -side.dy; };
        return std::ranges::find_if(fill, is_opposite)->owns != side.owns;
    });
}

void Findings::add_fill(const FillSides& fill) {
    const bool single = has_single_owners(fill), is_promised = allowed_.has_single_owners();
    list_.push_back({"fill_side",
                     "edges that own centres on them",
                     {},
                     "",
                     fill_in_words(fill) + (single ? "" : ": not one owner each"),
                     is_promised ? "one owner each" : "",
                     is_promised ? conformity_of(!single) : Conformity::undeclared});
}

void Findings::add_watertightness(const Watertightness& w) {
    const auto count = [](std::uint64_t n) { return Bracket{double(n), double(n)}; };
    const std::string of = "of " + std::to_string(w.pixels) + " pixels of closed meshes";
    list_.push_back({"holes", "holes", count(w.holes), "", of, "0",
                     conformity_of(w.holes > 0 && allowed_.is_watertight())});
    const bool is_promised = allowed_.has_single_owners();
    list_.push_back({"double_hits", "double hits", count(w.double_hits), "", of, is_promised ? "0" : "",
                     is_promised ? conformity_of(w.double_hits > 0) : Conformity::undeclared});
}

std::string in_projection(Projection projection) {
    return projection == Projection::parallel ? "parallel" : "perspective";
}

/// Depths further apart than twice what each may be off are told apart.
void Findings::add_depth_step(const DepthStep& step) {
    const double binade = std::exp2(std::floor(std::log2(step.depth)) + 1);
    const std::string where = in_projection(step.projection) + ", at " + with_digits(step.depth, 6);
    const std::string key = in_projection(step.projection) + "_at_" + with_digits(step.depth, 6);
    const double most = allowed_.depth_of(step);
    const auto bits_of = [&](double width) { return std::log2(binade / width); };
    Finding bits{"depth_bits_" + key,
                 "depth bits, " + where,
                 Bracket{bits_of(step.step.high), bits_of(step.step.low)},
                 "bits",
                 "told apart from " + with_digits(step.step.middle(), 3),
                 "",
                 Conformity::undeclared};
    Finding error{"depth_error_" + key,  "depth error, " + where, Bracket{step.error, step.error}, "", "", "",
                  Conformity::undeclared};
    if (allowed_.is_raster()) {
        bits.declared = ">= " + with_digits(bits_of(2 * most), 4);
        bits.conformity = conformity_of(step.step.low > 2 * most);
        error.declared = "<= " + with_digits(most, 3);
        error.conformity = conformity_of(step.error > most);
    }
    list_.push_back(bits);
    list_.push_back(error);
}

void Findings::add_limit(const DepthLimit& limit) {
    const std::string plane = limit.plane == LimitPlane::near ? "near" : "far";
    Finding f{plane + "_" + in_projection(limit.projection),
              plane + " plane, " + in_projection(limit.projection),
              {},
              "",
              "",
              "cuts at " + with_digits(limit.depth, 6),
              Conformity::worse};
    if (limit.offset) {
        const double slack = allowed_.limit_of(limit);
        f.words = std::string{"cuts; what lies in it is "} + (limit.keeps_plane ? "kept" : "dropped");
        f.value = limit.plane == LimitPlane::near
                      ? Bracket{limit.depth - limit.offset->high, limit.depth - limit.offset->low}
                      : Bracket{limit.depth + limit.offset->low, limit.depth + limit.offset->high};
        f.conformity = allowed_.is_raster()
                           ? conformity_of(limit.offset->low > slack || limit.offset->high < -slack)
                           : Conformity::undeclared;
    } else {
        f.words = "does not cut";
    }
    list_.push_back(f);
}

}  // namespace

std::vector<Finding> findings(const Measurement& measurement, const Precision& declared) {
    const Allowed allowed(declared);
    return Findings(measurement, allowed).all();
}

bool is_worse(std::span<const Finding> findings) {
    return std::ranges::count(findings, Conformity::worse, &Finding::conformity) > 0;
}

}  // namespace zproof::measure
