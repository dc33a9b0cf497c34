#include "lessons/depth/scene_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "compare/bounds/triangle_image.h"
#include "math/interval.h"
#include "math/interval_functions.h"
#include "math/rational.h"
#include "rasterizer/rasterizer.h"

namespace zproof::study::depth {
namespace {

constexpr double no_depth = std::numeric_limits<double>::quiet_NaN();

std::array<glm::dvec3, 3> world_corners(const Scene& scene, std::uint32_t triangle) {
    const glm::uvec3 index = scene.triangles[triangle];
    const auto& p = scene.vertices.position_world;
    return {glm::dvec3(p[index.x]), glm::dvec3(p[index.y]), glm::dvec3(p[index.z])};
}

template <class Number>
std::optional<Number> inverse_depth_at(const ViewRays<Number>& rays, Pixel p,
                                       const std::array<glm::dvec3, 3>& corners) {
    const Corners<Number> exact{exactly<Number>(corners[0]), exactly<Number>(corners[1]),
                                exactly<Number>(corners[2])};
    const auto inverse_depth = inverse_depth_of(rays.at(p.x, p.y), exact);
    if (!inverse_depth) return std::nullopt;
    return inverse_depth->c;
}

/// The plane's depth at the pixel's centre; NaN where the plane holds the eye.
class ExactDepths {
  public:
    explicit ExactDepths(const View& view) : quick_(view), last_(view) {}

    double at(Pixel p, const std::array<glm::dvec3, 3>& corners) const {
        try {
            const auto inverse_depth = inverse_depth_at(quick_, p, corners);
            if (!inverse_depth) return no_depth;
            const Interval depth = Interval{1} / *inverse_depth;
            if (radius(depth) <= 0x1p-40 * std::abs(middle(depth))) return middle(depth);
        } catch (const UndecidedSign&) {
        }
        const auto inverse_depth = inverse_depth_at(last_, p, corners);
        if (!inverse_depth || sign(*inverse_depth) == 0) return no_depth;
        return (1 / *inverse_depth).convert_to<double>();
    }

  private:
    ViewRays<Interval> quick_;
    ViewRays<Rational> last_;
};

/// A corner in camera space; z is the depth, positive.
using CameraPoint = glm::dvec3;

class Projector {
  public:
    explicit Projector(const View& view) : view_(view) {}

    CameraPoint camera(const glm::dvec3& p_world) const {
        const Camera& c = view_.camera;
        const glm::dvec3 from_eye = p_world - glm::dvec3(c.eye_world);
        return {glm::dot(c.right, from_eye), glm::dot(c.up, from_eye), -glm::dot(c.back, from_eye)};
    }
    glm::dvec2 raster(const CameraPoint& p) const {
        const Window& w = view_.camera.window;
        return {(p.x / p.z - w.left) / (w.right - w.left) * view_.width,
                (w.top - p.y / p.z) / (w.top - w.bottom) * view_.height};
    }
    /// The largest coordinate that enters a raster position, px.
    double reach(const CameraPoint& p) const {
        const Window& w = view_.camera.window;
        const double px_per_unit =
            std::max(view_.width / (w.right - w.left), view_.height / (w.top - w.bottom));
        const double offset =
            std::max({std::abs(w.left), std::abs(w.right), std::abs(w.top), std::abs(w.bottom)});
        return px_per_unit * ((std::abs(p.x) + std::abs(p.y) + std::abs(p.z)) / p.z + offset);
    }

  private:
    const View& view_;
};

/// What near leaves, as a fan: nothing, one triangle or two.
std::vector<std::array<CameraPoint, 3>> before_near(const std::array<CameraPoint, 3>& corners, double near) {
    std::vector<CameraPoint> kept;
    for (std::size_t i = 0; i < 3; ++i) {
        const CameraPoint &a = corners[i], &b = corners[(i + 1) % 3];
        if (a.z >= near) kept.push_back(a);
        if ((a.z >= near) == (b.z >= near)) continue;
        CameraPoint cut = a + (near - a.z) / (b.z - a.z) * (b - a);
        cut.z = near;
        kept.push_back(cut);
    }
    std::vector<std::array<CameraPoint, 3>> fan;
    for (std::size_t i = 2; i < kept.size(); ++i) fan.push_back({kept[0], kept[i - 1], kept[i]});
    return fan;
}

SeenTriangle begun(const Projector& projector, const std::array<CameraPoint, 3>& corners) {
    SeenTriangle seen;
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        seen.drawn.p_raster[i] = projector.raster(corners[i]);
        seen.drawn.depth[i] = float(corners[i].z);
        reach = std::max(reach, projector.reach(corners[i]));
    }
    seen.weight_error = weight_error_of(seen.drawn, reach);
    return seen;
}

/// How far inside a position is: its least barycentric.
double depth_inside(const Drawn& triangle, Pixel p) {
    if (triangle.doubled_area() == 0) return -std::numeric_limits<double>::infinity();
    return std::ranges::min(weights_at(triangle, {p.x + 0.5, p.y + 0.5}));
}

/// Indices of the pixels that show something, by triangle, then in raster order.
std::vector<std::size_t> by_triangle(const Frame& frame) {
    std::vector<std::size_t> order;
    const auto ids = frame.primitive.pixels();
    for (std::size_t i = 0; i < ids.size(); ++i)
        if (ids[i] != PrimitiveId::none) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::uint32_t(ids[i]); });
    return order;
}

/// The pixels of one triangle of the scene, shared out among what near leaves of it. A pixel whose sample
/// lies outside by more than a pixel's snap would be the rasterizer's fault; it is studied all the same.
class Sharing {
  public:
    Sharing(const Scene& scene, const View& view, const Planes& planes)
        : scene_(scene), planes_(planes), projector_(view), exact_(view), width_(view.width) {}

    std::vector<SeenTriangle> share(std::uint32_t triangle, std::span<const std::size_t> pixels) const {
        const auto world = world_corners(scene_, triangle);
        std::vector<SeenTriangle> pieces;
        for (const auto& part : before_near(
                 {projector_.camera(world[0]), projector_.camera(world[1]), projector_.camera(world[2])},
                 planes_.near)) {
            SeenTriangle piece = begun(projector_, part);
            if (piece.drawn.doubled_area() != 0) pieces.push_back(std::move(piece));
        }
        if (pieces.empty()) return pieces;
        for (const std::size_t i : pixels) {
            const Pixel p{int(i % std::size_t(width_)), int(i / std::size_t(width_))};
            const double depth = exact_.at(p, world);
            if (!(depth >= planes_.near && depth <= planes_.far)) continue;
            const auto inside = [&](const SeenTriangle& s) { return depth_inside(s.drawn, p); };
            const auto best = std::ranges::max_element(pieces, {}, inside);
            // Snapping lets a pixel show a triangle that its centre just misses; interpolation asks for more.
            if (inside(*best) >= 0) best->pixels.push_back({p, depth});
        }
        std::erase_if(pieces, [](const SeenTriangle& s) { return s.pixels.empty(); });
        return pieces;
    }

  private:
    const Scene& scene_;
    Planes planes_;
    Projector projector_;
    ExactDepths exact_;
    int width_;
};

void summarize(Seen& seen, std::size_t shown) {
    std::vector<double> depths;
    for (const SeenTriangle& t : seen.triangles)
        for (const SeenPixel& p : t.pixels) depths.push_back(p.depth);
    seen.pixels = depths.size();
    seen.left_out = shown - depths.size();
    if (depths.empty()) return;
    std::ranges::sort(depths);
    seen.nearest = depths.front();
    seen.farthest = depths.back();
    seen.median = depths[depths.size() / 2];
}

std::vector<Pixel> places(const SeenTriangle& seen) {
    std::vector<Pixel> pixels;
    for (const SeenPixel& p : seen.pixels) pixels.push_back(p.at);
    return pixels;
}

/// What `forward` does on a triangle, for its bound.
DepthSample place_of(const SeenTriangle& seen, const Coder& coder, std::span<const Pixel> pixels) {
    const auto& d = seen.drawn.depth;
    DepthSample place{.nearest = std::min({d[0], d[1], d[2]}),
                      .farthest = std::max({d[0], d[1], d[2]}),
                      .weight_error = seen.weight_error};
    const Pixel start = start_of(pixels);
    const Plane3 plane =
        plane_through(seen.drawn, {coder.of_depth(d[0]), coder.of_depth(d[1]), coder.of_depth(d[2])}, start);
    for (const Pixel p : pixels) {
        place.across = std::max(place.across, p.x - start.x);
        place.down = std::max(place.down, p.y - start.y);
    }
    place.per_x = plane.per_x;
    place.per_y = plane.per_y;
    // Affine: its largest magnitude over the rectangle that is stepped through is at one of its corners.
    for (const int x : {0, place.across})
        for (const int y : {0, place.down})
            place.largest =
                std::max(place.largest, std::abs(plane.start + plane.per_x * x + plane.per_y * y));
    return place;
}

/// One pixel's error.
struct PixelError {
    double absolute = 0, share = 0, of_bound = 0;
    Pixel at;
};

std::vector<PixelError> errors_of(const SeenTriangle& seen, const Coder& coder, Interpolation how) {
    const std::vector<Pixel> pixels = places(seen);
    const std::vector<float> s = interpolated(seen.drawn, pixels, coder, how);
    DepthSample place = place_of(seen, coder, pixels);
    std::vector<PixelError> errors;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double exact = seen.pixels[i].depth;
        place.depth = exact;
        const double off = std::abs(coder.depth_of(coder.stored(s[i])) - exact);
        errors.push_back({off, off / exact, off / depth_bound(coder, how, place), pixels[i]});
    }
    return errors;
}

double quantile(const std::vector<double>& sorted, double q) {
    return sorted[std::min(sorted.size() - 1, std::size_t(q * double(sorted.size())))];
}

void add_up(ErrorSpread& spread, std::vector<double> shares) {
    spread.pixels = shares.size();
    spread.histogram.assign(histogram_ends().size(), 0);
    if (shares.empty()) return;
    std::ranges::sort(shares);
    spread.median = quantile(shares, 0.5);
    spread.p99 = quantile(shares, 0.99);
    spread.largest = shares.back();
    const std::vector<double> ends = histogram_ends();
    for (const double share : shares) {
        const auto bin = std::ranges::lower_bound(ends, share);
        ++spread.histogram[std::size_t(std::min(bin, ends.end() - 1) - ends.begin())];
    }
}

std::size_t fights_on(const SeenTriangle& seen, const Coder& coder, double delta) {
    const std::vector<Pixel> pixels = places(seen);
    Drawn behind = seen.drawn;
    for (float& d : behind.depth) d = float(double(d) + delta);
    const auto front = interpolated(seen.drawn, pixels, coder, Interpolation::reciprocal);
    const auto back = interpolated(behind, pixels, coder, Interpolation::reciprocal);
    std::size_t fights = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        fights += coder.is_nearer(coder.stored(front[i]), coder.stored(back[i])) ? 0 : 1;
    return fights;
}

}  // namespace

Seen seen_in(const Scene& scene, const View& view, const Planes& planes) {
    if (view.camera.projection != Projection::perspective)
        throw std::invalid_argument(
            "view " + view.name +
            ": depth is affine in a parallel projection; expected a perspective camera");
    const Frame frame = rasterizer::render(scene, view);
    const std::vector<std::size_t> order = by_triangle(frame);
    const auto id_at = [&](std::size_t k) { return std::uint32_t(frame.primitive.pixels()[order[k]]); };
    std::vector<std::size_t> first;
    for (std::size_t k = 0; k < order.size(); ++k)
        if (k == 0 || id_at(k) != id_at(k - 1)) first.push_back(k);
    first.push_back(order.size());

    const Sharing sharing{scene, view, planes};
    std::vector<std::vector<SeenTriangle>> pieces(first.size() - 1);
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t t) {
        pieces[t] =
            sharing.share(id_at(first[t]), std::span(order).subspan(first[t], first[t + 1] - first[t]));
    });
    Seen seen;
    seen.size = frame.size();
    for (auto& of_one : pieces) std::ranges::move(of_one, std::back_inserter(seen.triangles));
    summarize(seen, order.size());
    return seen;
}

std::vector<double> histogram_ends() {
    std::vector<double> ends;
    for (int half_decade = -18; half_decade <= 0; ++half_decade)
        ends.push_back(std::pow(10, half_decade / 2.0));
    ends.push_back(std::numeric_limits<double>::infinity());
    return ends;
}

ErrorSpread error_spread(const Seen& seen, const Format& format, Interpolation interpolation,
                         const Planes& planes) {
    const Coder coder{format, planes};
    std::vector<std::vector<PixelError>> errors(seen.triangles.size());
    tbb::parallel_for(std::size_t{0}, errors.size(),
                      [&](std::size_t t) { errors[t] = errors_of(seen.triangles[t], coder, interpolation); });
    ErrorSpread spread;
    spread.format = format;
    spread.interpolation = interpolation;
    spread.map = Plane<float>(seen.size, std::numeric_limits<float>::quiet_NaN());
    std::vector<double> shares;
    for (const auto& of_triangle : errors)
        for (const PixelError& e : of_triangle) {
            shares.push_back(e.share);
            spread.map.at(e.at.x, e.at.y) = float(e.share);
            spread.largest_absolute = std::max(spread.largest_absolute, e.absolute);
            spread.largest_of_bound = std::max(spread.largest_of_bound, e.of_bound);
        }
    add_up(spread, std::move(shares));
    return spread;
}

double fighting_share(const Seen& seen, const Format& format, const Planes& planes, double delta) {
    const Coder coder{format, planes};
    std::vector<std::size_t> fights(seen.triangles.size());
    tbb::parallel_for(std::size_t{0}, fights.size(),
                      [&](std::size_t t) { fights[t] = fights_on(seen.triangles[t], coder, delta); });
    const std::size_t sum = std::accumulate(fights.begin(), fights.end(), std::size_t{0});
    return seen.pixels == 0 ? 0 : double(sum) / double(seen.pixels);
}

}  // namespace zproof::study::depth
