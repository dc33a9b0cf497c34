#include "oracle/oracle_error.h"
#include "rasterizer/rasterizer.h"
#include "scenes/judged_ranges.h"
#include "zproof/data.h"
#include "zproof/errors.h"
#include "zproof/ids.h"

namespace zproof::api {
namespace {

Frame frame_of(zproof::Frame frame) {
    return Frame{std::make_shared<Frame::Data>(Frame::Data{std::move(frame)})};
}

}  // namespace

Size Frame::size() const {
    const Resolution size = data().frame.size();
    return {size.width, size.height};
}

std::span<const std::uint32_t> Frame::id() const { return ids_of(data().frame); }
std::span<const float> Frame::depth() const { return data().frame.camera_depth.pixels(); }

Frame render(const Scene& scene, const View& view) {
    return told_as_input_error([&] {
        require_judged(view.data().view);
        return frame_of(rasterizer::render(scene.data().scene, view.data().view));
    });
}

Frame trace(const Scene& scene, const View& view) {
    return told_as_input_error([&] {
        require_judged(view.data().view);
        return frame_of(scene.data().embree().trace(view.data().view));
    });
}

}  // namespace zproof::api
