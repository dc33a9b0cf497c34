#include <algorithm>
#include <charconv>
#include <cmath>

#include "math/rounding.h"
#include "measure/measure.h"

namespace zproof::measure {
namespace {

/// What the declared precision allows in the probe views, after docs/bounds.md. Nothing where it is not
/// promised: a ray caster has no grid and no depth buffer.
struct Allowed {
    std::optional<int> subpixel_bits;
    Snap snap = Snap::nearest;
    double eps_px = 0;          ///< of a vertex, without the grid
    double depth_relative = 0;  ///< of a depth in the frame
    double limit_relative = 0;  ///< of the place where near or far cuts
    double parallel_units = 0;  ///< more for a parallel projection, as a multiple of far

    double depth_of(const DepthStep& step) const {
        return depth_relative * step.depth + beyond(step.projection, depth_far);
    }
    double limit_of(const DepthLimit& limit) const {
        return limit_relative * limit.depth + beyond(limit.projection, limit_far);
    }

    /// How far the grid may move a vertex either way.
    double snap_px() const {
        const double step = std::exp2(-*subpixel_bits);
        return snap == Snap::nearest ? step / 2 : step;
    }

  private:
    static constexpr double depth_far = 512, limit_far = 96;  ///< of depth_steps.cpp and depth_limits.cpp
    double beyond(Projection projection, double far) const {
        return projection == Projection::parallel ? parallel_units * far : 0;
    }
};

double unit_of(Arithmetic arithmetic) {
    return arithmetic == Arithmetic::float32 ? unit_roundoff_float32 : unit_roundoff_float64;
}

/// Where corners in the probe views lie: |p| + |eye|, in pixels and as a multiple of the depth, and the
/// distance from the window's centre.
constexpr double from_origin_px = 128, from_origin_depth = 1.25, reach_px = 64;

/// Relative roundings from a corner's depth to a pixel's, beside depth_roundings.
double interpolation_factor(const RasterPrecision& p) {
    switch (p.depth_buffer) {
        case DepthBuffer::camera_depth:
            return gamma(8, unit_of(p.interpolation));
        case DepthBuffer::reversed_z:  // of triangles that face the camera: 4 at a corner, 8 at a pixel
            return gamma(12, unit_roundoff_float32);
    }
    return 0;
}

/// The rounding of z = (far - depth) / (far - near) under a parallel projection, as a multiple of far.
double parallel_units(const RasterPrecision& p) {
    switch (p.depth_buffer) {
        case DepthBuffer::camera_depth:
            return 0;
        case DepthBuffer::reversed_z:  // z is at most 1
            return gamma(12, unit_roundoff_float32) + gamma(6, unit_roundoff_float32);
    }
    return 0;
}

Allowed allowed_by(const RasterPrecision& p) {
    const double u = unit_of(p.transform);
    const int eye = p.origin == Origin::eye ? 1 : 0;
    const double transform =
        gamma((p.transform == Arithmetic::float64 ? 13 : 5) + eye, u);  // the axes are exact
    const double corner_depth = transform * from_origin_depth;
    const double interpolation = gamma(p.depth_roundings, unit_roundoff_float32) + interpolation_factor(p);
    return {.subpixel_bits = p.subpixel_bits,
            .snap = p.snap,
            .eps_px = transform * from_origin_px + gamma(8, u) * reach_px,
            .depth_relative = corner_depth + interpolation,
            .limit_relative = corner_depth + gamma(8, u) * from_origin_depth,
            .parallel_units = parallel_units(p)};
}

Allowed allowed_by(const RayPrecision&) { return {}; }
Allowed allowed_by(const PlaneRayPrecision&) { return {}; }

std::string number(double value, int digits = 6) {
    std::array<char, 64> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits)
            .ptr;
    return {buffer.data(), end};
}

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
            f.words = "no grid of " + number(-std::log2(found.finest_px)) + " bits or fewer";
        if (allowed_.subpixel_bits) {
            f.declared = number(*allowed_.subpixel_bits);
            f.conformity = conformity_of(f.value && f.value->high < *allowed_.subpixel_bits);
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
                  "from " + number(low) + " to " + number(high),
                  "",
                  Conformity::undeclared};
        if (allowed_.subpixel_bits) {
            const double most = allowed_.snap_px() + allowed_.eps_px;
            f.declared = "<= " + number(most);
            f.conformity = conformity_of(greatest > most);
        }
        list_.push_back(f);
    }

    void add_snap(const SnapGrid& grid, Axis axis) {
        Finding f{
            with_axis("snap", axis, "_"), with_axis("snap", axis, ", "), {}, "", snap_in_words(grid), "",
            Conformity::undeclared};
        if (allowed_.subpixel_bits) {
            f.declared = allowed_.snap == Snap::nearest ? "nearest" : "truncated";
            f.conformity =
                conformity_of(allowed_.snap == Snap::nearest && grid.snap != SnapRounding::nearest);
        }
        list_.push_back(f);
    }

    void add_fill(const FillSides& fill);
    void add_watertightness(const Watertightness& w);
    void add_depth_step(const DepthStep& step);
    void add_limit(const DepthLimit& limit);

    const Measurement& m_;
    Allowed allowed_;
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
    const bool single = has_single_owners(fill);
    list_.push_back({"fill_side",
                     "edges that own centres on them",
                     {},
                     "",
                     fill_in_words(fill) + (single ? "" : ": not one owner each"),
                     "one owner each",
                     conformity_of(!single)});
}

void Findings::add_watertightness(const Watertightness& w) {
    const auto count = [](std::uint64_t n) { return Bracket{double(n), double(n)}; };
    const std::string of = "of " + std::to_string(w.pixels) + " pixels of closed meshes";
    list_.push_back({"holes", "holes", count(w.holes), "", of, "0", conformity_of(w.holes > 0)});
    list_.push_back(
        {"double_hits", "double hits", count(w.double_hits), "", of, "0", conformity_of(w.double_hits > 0)});
}

std::string in_projection(Projection projection) {
    return projection == Projection::parallel ? "parallel" : "perspective";
}

/// Depths further apart than twice what each may be off are told apart.
void Findings::add_depth_step(const DepthStep& step) {
    const double binade = std::exp2(std::floor(std::log2(step.depth)) + 1);
    const std::string where = in_projection(step.projection) + ", at " + number(step.depth);
    const std::string key = in_projection(step.projection) + "_at_" + number(step.depth);
    const double most = allowed_.depth_of(step);
    const auto bits_of = [&](double width) { return std::log2(binade / width); };
    Finding bits{"depth_bits_" + key,
                 "depth bits, " + where,
                 Bracket{bits_of(step.step.high), bits_of(step.step.low)},
                 "bits",
                 "told apart from " + number(step.step.middle(), 3),
                 "",
                 Conformity::undeclared};
    Finding error{"depth_error_" + key,  "depth error, " + where, Bracket{step.error, step.error}, "", "", "",
                  Conformity::undeclared};
    if (allowed_.subpixel_bits) {
        bits.declared = ">= " + number(bits_of(2 * most), 4);
        bits.conformity = conformity_of(step.step.low > 2 * most);
        error.declared = "<= " + number(most, 3);
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
              "cuts at " + number(limit.depth),
              Conformity::worse};
    if (limit.offset) {
        const double slack = allowed_.limit_of(limit);
        f.words = std::string{"cuts; what lies in it is "} + (limit.keeps_plane ? "kept" : "dropped");
        f.value = limit.plane == LimitPlane::near
                      ? Bracket{limit.depth - limit.offset->high, limit.depth - limit.offset->low}
                      : Bracket{limit.depth + limit.offset->low, limit.depth + limit.offset->high};
        f.conformity = allowed_.subpixel_bits
                           ? conformity_of(limit.offset->low > slack || limit.offset->high < -slack)
                           : Conformity::undeclared;
    } else {
        f.words = "does not cut";
    }
    list_.push_back(f);
}

}  // namespace

std::vector<Finding> findings(const Measurement& measurement, const Precision& declared) {
    const Allowed allowed = std::visit([](const auto& precision) { return allowed_by(precision); }, declared);
    return Findings(measurement, allowed).all();
}

bool is_worse(std::span<const Finding> findings) {
    return std::ranges::count(findings, Conformity::worse, &Finding::conformity) > 0;
}

}  // namespace zproof::measure
