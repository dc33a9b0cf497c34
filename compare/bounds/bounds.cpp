#include "compare/bounds/bounds.h"

#include <algorithm>
#include <cmath>

#include "frame/frame_error.h"

namespace zproof {

namespace {

RasterBounds for_kind(const ViewFacts& facts, const RasterPrecision& p) { return {facts, p}; }
RayBounds for_kind(const ViewFacts& facts, const RayPrecision& p) { return {facts, p}; }
PlaneRayBounds for_kind(const ViewFacts& facts, const PlaneRayPrecision& p) { return {facts, p}; }
BoundedBounds for_kind(const ViewFacts& facts, const BoundedPrecision& p) { return {facts, p}; }

bool ends_at_the_eye(const Precision& precision) {
    const auto* raster = std::get_if<RasterPrecision>(&precision);
    return raster != nullptr && raster->nothing_behind_the_eye;
}

/// The precision of the depths that a frame shows, where the depth test may have another.
Precision shown_precision(const Precision& precision) {
    const auto* raster = std::get_if<RasterPrecision>(&precision);
    if (raster == nullptr || raster->shown_depth == ShownDepth::buffer) return precision;
    RasterPrecision reported = *raster;
    reported.depth_buffer = DepthBuffer::camera_depth;
    return reported;
}

void refuse_unjudgeable(const Camera& camera, const Precision& precision) {
    if (const std::string why = unjudgeable(camera, precision); !why.empty()) throw FrameError(why);
}

/// One of which nothing is known is taken to clip as hardware does: who clips at the sides declares it.
std::vector<Window> clip_windows_of(const View& view, const Precision& precision) {
    const auto* raster = std::get_if<RasterPrecision>(&precision);
    if (raster != nullptr && raster->edge_functions != EdgeFunctions::homogeneous)
        return {clip_window_of(view, raster->clipping)};
    if (!std::holds_alternative<BoundedPrecision>(precision)) return {};
    return {clip_window_of(view, Clipping::guard_band)};
}

/// A depth is rounded to the nearest step, and that to float32.
void allow_steps(double depth_step, TriangleBounds& bounds) {
    constexpr double u = unit_roundoff_float32;
    bounds.depth_factor += u;
    bounds.depth_share *= 1 + u;
    bounds.inverse_depth_error *= 1 + 2 * u;
    bounds.depth_absolute = (bounds.depth_absolute + depth_step / 2) * (1 + u);
}

}  // namespace

bool is_watertight(const Precision& precision) {
    return std::visit(
        [](const auto& p) {
            if constexpr (requires { p.watertight; }) return p.watertight;
            return true;
        },
        precision);
}

std::string unjudgeable(const Camera& camera, const Precision& precision) {
    const double share = std::visit(
        [](const auto& p) {
            if constexpr (requires { p.depth_of_range; }) return p.depth_of_range;
            return 0.0;
        },
        precision);
    return share > 0 && std::isinf(camera.far_depth) ? "depth_of_range is a share of far - near, and far is "
                                                       "infinite; expected a view with a finite "
                                                       "far plane (a glTF camera's zfar), or another promise"
                                                     : "";
}

ViewBounds::ViewBounds(const View& view, const Precision& precision)
    : facts_((refuse_unjudgeable(view.camera, precision), view)),
      near_depth_(ends_at_the_eye(precision) ? std::max(view.camera.near_depth, 0.0)
                                             : view.camera.near_depth),
      depth_step_(std::visit([](const auto& p) { return p.depth_step; }, precision)),
      is_watertight_(zproof::is_watertight(precision)),
      clip_windows_(clip_windows_of(view, precision)),
      of_kind_(std::visit([&](const auto& p) -> OfKind { return for_kind(facts_, p); }, precision)) {}

ViewBounds ViewBounds::of_shown(const View& view, const Precision& precision) {
    ViewBounds bounds(view, shown_precision(precision));
    bounds.is_of_shown_ = bounds.depth_step_ > 0;
    const auto* raster = std::get_if<RasterPrecision>(&precision);
    if (raster && raster->shown_depth == ShownDepth::varying)
        bounds.clipping_.emplace(bounds.facts_, *raster);
    return bounds;
}

TriangleBounds ViewBounds::of(const TriangleExtent& extent) const {
    TriangleBounds bounds = std::visit([&](const auto& kind) { return kind.of(facts_, extent); }, of_kind_);
    const Camera& c = facts_.view.camera;
    const auto [low, high] = std::ranges::minmax(extent.size.depth);
    double near = c.near_depth, far = c.far_depth;
    if (clipping_ && (low < near || high > far)) {
        const TriangleBounds cut = clipping_->of(facts_, extent);
        near -= cut.near_slack, far += cut.far_slack;
    }
    bounds.nearest = std::clamp(low, near, far);
    bounds.farthest = std::clamp(high, near, far);
    const double before_near = std::max(low, c.near_depth - bounds.near_slack);
    bounds.nearest_shown =
        facts_.perspective && before_near > 0 ? std::min(before_near, bounds.nearest) : bounds.nearest;
    if (is_of_shown_) allow_steps(depth_step_, bounds);
    return bounds;
}

InverseDepthRange ViewBounds::compared_at(double depth) const {
    if (depth_step_ == 0) return compared_before_steps(depth);
    const double room = step_room(depth);
    return {compared_before_steps(depth + room).least, compared_before_steps(depth - room).greatest};
}

InverseDepthRange ViewBounds::compared_before_steps(double depth) const {
    const auto* ray = std::get_if<RayBounds>(&of_kind_);
    if (!(raster() && raster()->shows_what_it_compares()) && !(ray && ray->has_depth_of_distance()))
        return any_inverse_depth;
    const double here = inverse_depth_of(depth, projection()),
                 error = std::abs(here) * gamma(2, unit_roundoff_float32) +
                         (raster() ? raster()->decoding_error(facts_) : 0);
    return facts_.perspective && !(depth > 0) ? any_inverse_depth
                                              : InverseDepthRange{here - error, here + error};
}

bool ViewBounds::can_be_stored(double depth) const {
    if (!raster() || !raster()->shows_what_it_compares()) return true;
    const InverseDepthRange stored = raster()->storable(facts_), here = compared_at(depth);
    return here.greatest >= stored.least && here.least <= stored.greatest;
}

double ViewBounds::background_eps_px() const {
    return std::visit([](const auto& kind) { return kind.background_eps_px(); }, of_kind_);
}

}  // namespace zproof
