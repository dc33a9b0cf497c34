#include "scenes/suite/views.h"

namespace zproof::suite {

Window centred_window(ImageSize size, double half_height) {
    const double half_width = half_height * size.aspect();
    return {.left = -half_width, .right = half_width, .bottom = -half_height, .top = half_height};
}

View perspective_view(const std::string& name, ImageSize size, const Stance& stance, const Lens& lens) {
    View view{.name = name,
              .camera = look_at(stance.eye_world, stance.target_world, stance.up_world),
              .width = size.width,
              .height = size.height};
    view.camera.window = centred_window(size, lens.half_height);
    view.camera.near_depth = lens.near_depth;
    view.camera.far_depth = lens.far_depth;
    return view;
}

View parallel_view(const std::string& name, ImageSize size, const Stance& stance, const Lens& lens) {
    View view = perspective_view(name, size, stance, lens);
    view.camera.projection = Projection::parallel;
    return view;
}

}  // namespace zproof::suite
