#include "oracle/povray/budget.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/mixed.h"
#include "oracle/oracle_error.h"
#include "oracle/povray/geometry.h"
#include "oracle/povray/raster_box.h"

namespace zproof::oracle {
namespace {

constexpr std::uint64_t most_pixels = 320 * 180;

/// In microseconds of one core, rounded, of an AMD EPYC of 2021 with POV-Ray 3.7.0.10.
constexpr double most_work = 2e6, work_of_triangle = 16, work_of_box = 0.3;

std::uint64_t rays_met_by(const PovrayCluster& cluster, const View& view, double scale) {
    const auto& [low, high] = std::pair{cluster.lowest, cluster.highest};
    const std::array<glm::dvec3, 8> corners{{{low.x, low.y, low.z},
                                             {low.x, low.y, high.z},
                                             {low.x, high.y, low.z},
                                             {low.x, high.y, high.z},
                                             {high.x, low.y, low.z},
                                             {high.x, low.y, high.z},
                                             {high.x, high.y, low.z},
                                             {high.x, high.y, high.z}}};
    return centres_around(corners, view, scale);
}

/// What POV-Ray has to do for a view.
struct Work {
    std::uint64_t triangles = 0, boxes_met = 0;

    double of_reading() const { return work_of_triangle * double(triangles); }
    double of_tracing() const { return work_of_box * double(boxes_met); }
    bool is_affordable() const { return of_reading() + of_tracing() <= most_work; }
};

Work work_for(const Scene& scene, const View& view) {
    const PovrayGeometry geometry = povray_geometry(scene, view);
    Work work;
    for (const PovrayCluster& cluster : geometry.clusters) {
        work.triangles += cluster.triangles.size();
        work.boxes_met += rays_met_by(cluster, view, geometry.units.scale);
    }
    return work;
}

std::string in_words(const Work& work, const View& view) {
    if (work.of_reading() > work.of_tracing())
        return std::to_string(work.triangles) + " triangles are many to read";
    return "each ray meets " +
           std::to_string(work.boxes_met / (std::uint64_t(view.width) * std::uint64_t(view.height))) +
           " boxes of triangles";
}

PixelLattice lattice(int stride, const View& view, std::uint64_t seed) {
    const std::uint64_t drawn = mixed(seed);
    const auto place = [&](std::uint64_t bits, int pixels) {
        return int(bits % std::uint64_t(std::min(stride, pixels)));
    };
    return {stride, place(drawn & 0xFFFF'FFFF, view.width), place(drawn >> 32, view.height)};
}

}  // namespace

AffordablePixels affordable_pixels(const Scene& scene, const View& view, std::uint64_t seed) {
    AffordablePixels affordable;
    const double share = double(view.width) * view.height / double(most_pixels);
    for (int stride = int(std::ceil(std::sqrt(share)));; stride += (stride + 1) / 2) {
        affordable.lattice = lattice(stride, view, seed);
        const View some = view_of(affordable.lattice, view);
        const Work work = work_for(scene, some);
        affordable.seconds = 1e-6 * (work.of_reading() + work.of_tracing());
        if (work.is_affordable()) return affordable;
        affordable.fewer_because = in_words(work, some);
        if (some.width == 1 && some.height == 1)
            throw OracleError("POV-Ray: not asked about a sample, since " + affordable.fewer_because +
                              " even for one pixel; --oracle povray asks about all");
    }
}

}  // namespace zproof::oracle
