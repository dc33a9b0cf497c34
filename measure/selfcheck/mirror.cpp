#include "measure/selfcheck/frame_mapping.h"
#include "measure/selfcheck/variants.h"

namespace zproof::measure {
namespace {

/// -x, and 0 for 0: -0 does not survive every file.
template <class Vector>
Vector over_in_x(Vector v) {
    v.x = 0 - v.x;
    return v;
}

View mirrored_view(const View& view) {
    View turned = view;
    Camera& camera = turned.camera;
    camera.eye_world = over_in_x(camera.eye_world);
    camera.right = -over_in_x(camera.right);  // turned back, so that the axes stay right-handed
    camera.up = over_in_x(camera.up);
    camera.back = over_in_x(camera.back);
    camera.window.left = -view.camera.window.right;
    camera.window.right = -view.camera.window.left;
    camera.shear = over_in_x(camera.shear);
    return turned;
}

}  // namespace

Scene mirrored(const Scene& scene) {
    Scene turned = scene;
    for (glm::vec3& p : turned.vertices.position_world) p = over_in_x(p);
    for (glm::vec3& n : turned.vertices.normal_world) n = over_in_x(n);
    return turned;
}

std::vector<VariantPicture> mirrored_picture(const Scene&, const View& view) {
    const View turned = mirrored_view(view);
    const auto expected = [](const Frame& original) {
        const Resolution size = original.size();
        return mapped_frame(
            original, size,
            [size](int x, int y) {
                return Pixel{size.width - 1 - x, y};
            },
            [](PrimitiveId id, Pixel) { return id; });
    };
    return {{turned, turned, [](const Frame& rendered) { return rendered; }, expected}};
}

}  // namespace zproof::measure
