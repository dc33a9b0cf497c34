#include "compare/nearby_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "math/rounding.h"

namespace zproof {

namespace {

constexpr int tile_px = 16;
constexpr std::size_t chunk_triangles = 4096;

/// A box of raster space, pixels.
struct Box {
    double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;

    void add(double x, double y) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    void widen(double by) { left -= by, top -= by, right += by, bottom += by; }
    bool fits(double side) const { return right - left <= side && bottom - top <= side; }
    bool meets(const Box& o) const {
        return left <= o.right && o.left <= right && top <= o.bottom && o.top <= bottom;
    }
};

Box box_of(const Site& site) {
    Box box;
    box.add(site.x + 0.5, site.y + 0.5);
    box.widen(site.reach_px);
    return box;
}

/// World to raster for bounding boxes, in double.
class BoxProjection {
  public:
    explicit BoxProjection(const View& view)
        : camera_(view.camera),
          perspective_(camera_.projection == Projection::perspective),
          px_per_u_(view.width / (camera_.window.right - camera_.window.left)),
          px_per_v_(view.height / (camera_.window.top - camera_.window.bottom)) {}

    /// The image's box; nothing where the triangle lies behind half the near depth.
    std::optional<Box> operator()(const CornersWorld& p_world) const {
        std::array<glm::dvec3, 3> p_camera;
        double size = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 v = glm::dvec3(p_world[i]) - glm::dvec3(camera_.eye_world);
            p_camera[i] = {dot(camera_.right, v), dot(camera_.up, v), -dot(camera_.back, v)};
            size = std::max(size, std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
        }
        const std::optional<Box> box = bounds(p_camera);
        return box ? widened(*box, size) : box;
    }

  private:
    std::optional<Box> bounds(const std::array<glm::dvec3, 3>& p_camera) const {
        Box box;
        const double least = perspective_ ? camera_.near_depth / 2 : -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 &p = p_camera[i], &q = p_camera[(i + 1) % 3];
            if (p.z >= least) add(box, p);
            if ((p.z >= least) != (q.z >= least)) add(box, p + (least - p.z) / (q.z - p.z) * (q - p));
        }
        return box.left <= box.right ? std::optional(box) : std::nullopt;
    }

    void add(Box& box, const glm::dvec3& p) const {
        const double u = perspective_ ? p.x / p.z : p.x - camera_.shear.x * p.z;
        const double v = perspective_ ? p.y / p.z : p.y - camera_.shear.y * p.z;
        box.add((u - camera_.window.left) * px_per_u_, (camera_.window.top - v) * px_per_v_);
    }

    /// Rounding moves a camera-space corner by at most 4u |v|, and its quotient in the image by 16 times that
    /// over the least depth; scaling and the window's offset add a few ulps of the result.
    Box widened(Box box, double size) const {
        const double u = unit_roundoff_float64;
        const double reach = std::max(
            {std::abs(box.left), std::abs(box.right), std::abs(box.top), std::abs(box.bottom), 65536.0});
        const double slant = 1 + std::abs(camera_.shear.x) + std::abs(camera_.shear.y);
        const double scale = std::max(px_per_u_, px_per_v_) / (perspective_ ? camera_.near_depth / 2 : 1);
        box.widen(64 * u * size * slant * scale + 16 * u * reach);
        return box;
    }

    Camera camera_;
    bool perspective_;
    double px_per_u_, px_per_v_;
};

/// A triangle's three half-planes over the whole image, in double, each with the rounding error of its value.
class EdgeFilter {
  public:
    EdgeFilter(const View& view, const CornersWorld& p_world) {
        const Sight<double> sight(view, 0, 0);
        const Corners<double> p = corners<double>(p_world);
        const auto image = image_of(sight, p);
        if (!image) return;  // edge-on: let the exact arithmetic look
        edge_ = image->edge;
        for (std::size_t i = 0; i < 3; ++i)
            margin_[i] = rounding_error(view, sight, p[(i + 1) % 3], p[(i + 2) % 3]);
        trusted_ = true;
    }

    /// Is the square of this half-side around a raster position certainly beyond one edge?
    bool misses(double x_raster, double y_raster, double half_side_px) const {
        if (!trusted_) return false;
        for (std::size_t i = 0; i < 3; ++i) {
            const Affine<double>& e = edge_[i];
            const double nearest_inside = e.at(x_raster - 0.5, y_raster - 0.5) +
                                          half_side_px * (std::abs(e.a) + std::abs(e.b)) + margin_[i];
            if (nearest_inside < 0) return true;
        }
        return false;
    }

  private:
    /// 16 roundings at most in a triple product, with every difference and product in absolute value.
    static double rounding_error(const View& view, const Sight<double>& sight, const Vector3<double>& from,
                                 const Vector3<double>& to) {
        const auto size = [](const Vector3<double>& v) {
            return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
        };
        const double across = view.width * size(sight.step_x) + view.height * size(sight.step_y);
        const double moving = sight.projection == Projection::perspective ? 0 : across;
        const double corners_size = (size(from - sight.origin) + moving) * (size(to - sight.origin) + moving);
        return gamma(16, unit_roundoff_float64) * 2 * corners_size *
               (size(sight.direction) + across - moving);
    }

    std::array<Affine<double>, 3> edge_{};
    std::array<double, 3> margin_{};
    bool trusted_ = false;
};

/// Sites by tile of the image.
class SiteGrid {
  public:
    SiteGrid(const View& view, std::span<const Site> sites)
        : columns_((view.width + tile_px - 1) / tile_px),
          rows_((view.height + tile_px - 1) / tile_px),
          first_(std::size_t(columns_) * std::size_t(rows_) + 1) {
        for (const Site& site : sites) {
            largest_reach_ = std::max(largest_reach_, site.reach_px);
            ++first_[tile_of(site) + 1];
        }
        for (std::size_t t = 1; t < first_.size(); ++t) first_[t] += first_[t - 1];
        members_.resize(sites.size());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < sites.size(); ++i) members_[next[tile_of(sites[i])]++] = std::uint32_t(i);
    }

    /// May any site lie in the box?
    bool holds_sites(Box box) const {
        bool any = false;
        visit_rows(box, [&](int row, int left, int right) {
            any = any || first_[index(left, row)] != first_[index(right, row) + 1];
        });
        return any;
    }

    /// Visits the sites of every tile that the box meets and that `misses(x, y, half_side)` does not rule
    /// out.
    template <class Misses, class Visit>
    void visit(Box box, const Misses& misses, const Visit& visit_site) const {
        visit_rows(box, [&](int row, int left, int right) {
            if (first_[index(left, row)] == first_[index(right, row) + 1]) return;
            for (int column = left; column <= right; ++column) visit_tile(column, row, misses, visit_site);
        });
    }

  private:
    template <class VisitRow>
    void visit_rows(Box box, const VisitRow& visit_row) const {
        box.widen(largest_reach_);
        if (box.right < 0 || box.bottom < 0 || box.left > columns_ * tile_px || box.top > rows_ * tile_px)
            return;
        const int left = clamped(box.left, columns_), right = clamped(box.right, columns_);
        const int top = clamped(box.top, rows_), bottom = clamped(box.bottom, rows_);
        for (int row = top; row <= bottom; ++row) visit_row(row, left, right);
    }
    template <class Misses, class Visit>
    void visit_tile(int column, int row, const Misses& misses, const Visit& visit_site) const {
        const std::size_t begin = first_[index(column, row)], end = first_[index(column, row) + 1];
        constexpr double half = tile_px / 2.0;
        if (begin == end || misses(column * tile_px + half, row * tile_px + half, half + largest_reach_))
            return;
        for (std::size_t k = begin; k < end; ++k) visit_site(members_[k]);
    }
    static int clamped(double px, int count) { return int(std::clamp(px / tile_px, 0.0, count - 1.0)); }
    std::size_t index(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    }
    std::size_t tile_of(const Site& site) const { return index(site.x / tile_px, site.y / tile_px); }

    int columns_, rows_;
    double largest_reach_ = 0;
    std::vector<std::uint32_t> first_, members_;
};

struct Meeting {
    std::uint32_t site, triangle;
};

/// Finds the sites that one triangle meets. Its edges are asked only where its box does not say no.
class TriangleSearch {
  public:
    TriangleSearch(const View& view, const SiteGrid& grid, std::span<const Site> sites)
        : view_(view), grid_(grid), sites_(sites), box_projection_(view) {}

    template <class Visit>
    void operator()(const CornersWorld& p_world, const Visit& visit_site) const {
        const std::optional<Box> box = box_projection_(p_world);
        if (!box || !grid_.holds_sites(*box)) return;
        std::optional<EdgeFilter> edges;
        const auto misses = [&](double x, double y, double half_side) {
            if (!edges) edges.emplace(view_, p_world);
            return edges->misses(x, y, half_side);
        };
        const bool is_small = box->fits(tile_px);
        const auto misses_tile = [&](double x, double y, double half_side) {
            return !is_small && misses(x, y, half_side);
        };
        grid_.visit(*box, misses_tile, [&](std::uint32_t i) {
            const Site& site = sites_[i];
            if (box->meets(box_of(site)) && !misses(site.x + 0.5, site.y + 0.5, site.reach_px)) visit_site(i);
        });
    }

  private:
    const View& view_;
    const SiteGrid& grid_;
    std::span<const Site> sites_;
    BoxProjection box_projection_;
};

}  // namespace

void find_nearby_triangles(const Scene& scene, const View& view, std::span<Site> sites) {
    const SiteGrid grid(view, sites);
    const TriangleSearch search(view, grid, sites);
    std::vector<std::vector<Meeting>> chunks((scene.triangles.size() + chunk_triangles - 1) /
                                             chunk_triangles);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t chunk) {
        const std::size_t end = std::min(scene.triangles.size(), (chunk + 1) * chunk_triangles);
        for (std::size_t t = chunk * chunk_triangles; t < end; ++t)
            search(corners_of(scene, std::uint32_t(t)), [&](std::uint32_t site) {
                chunks[chunk].push_back({site, std::uint32_t(t)});
            });
    });
    for (Site& site : sites) site.triangles.clear();
    for (const auto& chunk : chunks)
        for (const Meeting& m : chunk) sites[m.site].triangles.push_back(m.triangle);
}

}  // namespace zproof
