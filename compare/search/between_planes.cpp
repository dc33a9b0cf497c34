#include "compare/search/between_planes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <functional>
#include <span>

#include "math/vector3.h"

namespace zproof {

bool lies_between_planes(const Scene& scene, const View& view) {
    const Camera& camera = view.camera;
    const auto eye = exactly<double>(glm::dvec3(camera.eye_world)), back = exactly<double>(camera.back);
    const std::span positions = scene.vertices.position_world;
    using Some = tbb::blocked_range<std::size_t>;
    const auto lie_between = [&](const Some& some, bool all) {
        for (const glm::vec3& p : positions.subspan(some.begin(), some.size())) {
            const double depth = -dot(back, exactly<double>(glm::dvec3(p)) - eye);  // as Gauge has it
            all &= depth > camera.near_depth && depth < camera.far_depth;
        }
        return all;
    };
    return tbb::parallel_reduce(Some(0, positions.size(), 4096), true, lie_between, std::logical_and<>());
}

}  // namespace zproof
