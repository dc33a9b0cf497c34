#include "scenes/suite/views.h"

namespace zproof::suite {

Window centred_window(ImageSize size, double half_height) {
    const double half_width = half_height * size.aspect();
    return {.left = -half_width, .right = half_width, .bottom = -half_height, .top = half_height};
}

View perspective_view(const std::string& name, ImageSize size, const CameraPose& pose,
                      const Intrinsics& intrinsics) {
    View view{.name = name,
              .camera = look_at(pose.eye_world, pose.target_world, pose.up_world),
              .width = size.width,
              .height = size.height};
    view.camera.window = centred_window(size, intrinsics.half_height);
    view.camera.near_depth = intrinsics.near_depth;
    view.camera.far_depth = intrinsics.far_depth;
    return view;
}

View parallel_view(const std::string& name, ImageSize size, const CameraPose& pose,
                   const Intrinsics& intrinsics) {
    View view = perspective_view(name, size, pose, intrinsics);
    view.camera.projection = Projection::parallel;
    return view;
}

}  // namespace zproof::suite
