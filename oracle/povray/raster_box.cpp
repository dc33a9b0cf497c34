#include "oracle/povray/raster_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zproof::oracle {
namespace {

/// Far above the rounding of a projection, which is some 2^-48 of the sums below, and of the rays' aim.
constexpr double margin_px = 0x1p-6, relative_margin = 0x1p-40, least_relative_depth = 0x1p-30;

/// An interval on the raster, px.
struct Extent {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void include(double place, double margin) {
        low = std::min(low, place - margin);
        high = std::max(high, place + margin);
    }

    /// How many of `pixels` in a row have their centre in it.
    std::uint64_t centres(int pixels) const {
        const double first = std::max(std::ceil(low - 0.5), 0.0);
        const double last = std::min(std::floor(high - 0.5), pixels - 1.0);
        return first <= last ? std::uint64_t(last - first) + 1 : 0;
    }
};

}  // namespace

std::uint64_t centres_around(std::span<const glm::dvec3> points_from_eye, const View& view, double unit) {
    const Camera& camera = view.camera;
    const Window& window = camera.window;
    const double x_px = view.width / (window.right - window.left);
    const double y_px = view.height / (window.top - window.bottom);
    Extent across, down;
    for (const glm::dvec3& point : points_from_eye) {
        const double depth = -glm::dot(camera.back, point);
        const double reach = std::abs(point.x) + std::abs(point.y) + std::abs(point.z);
        glm::dvec2 place{glm::dot(camera.right, point), glm::dot(camera.up, point)};
        double size = reach * (1 + std::abs(camera.shear.x) + std::abs(camera.shear.y)) / unit;
        if (camera.projection == Projection::perspective) {
            if (!(depth > least_relative_depth * reach))
                return std::uint64_t(view.width) * std::uint64_t(view.height);
            place /= depth;
            size = (reach / depth) * (reach / depth);
        } else {
            place = (place - depth * camera.shear) / unit;
        }
        across.include((place.x - window.left) * x_px, margin_px + relative_margin * size * x_px);
        down.include((window.top - place.y) * y_px, margin_px + relative_margin * size * y_px);
    }
    return across.centres(view.width) * down.centres(view.height);
}

}  // namespace zproof::oracle
