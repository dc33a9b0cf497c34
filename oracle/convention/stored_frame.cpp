#include "oracle/convention/stored_frame.h"

#include <string>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "image_io/raw_frame.h"
#include "oracle/convention/camera_depth.h"

namespace zproof::oracle {
namespace {

namespace fs = std::filesystem;

void refuse_other_size(const fs::path& file, Resolution size, const View& view) {
    if (size == Resolution{view.width, view.height}) return;
    throw FrameError(file.string() + ": " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                     " pixels; the view '" + view.name + "' has " + std::to_string(view.width) + " x " +
                     std::to_string(view.height));
}

Frame frame_of(const RawFrame& raw, const Convention& convention, const View& view, IdChannel ids) {
    const bool has_ids = ids == IdChannel::present;
    if (has_ids && !raw.primitive) throw FrameError(raw.why_no_ids);
    const CameraDepth camera_depth(convention, view);
    Frame frame({view.width, view.height});
    frame.attributes = raw.attributes;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const double stored = raw.stored_depth.at(x, y);
            const bool says_background = camera_depth.is_background(stored);
            PrimitiveId& id = frame.primitive.at(x, y) =
                has_ids ? raw.primitive->at(x, y) : PrimitiveId::none;
            if (convention.background_by == BackgroundBy::depth && says_background) id = PrimitiveId::none;
            // Where the file has no data, the raw depth is +infinity.
            const bool is_background =
                id == PrimitiveId::none && (says_background || stored == double(background_depth));
            frame.camera_depth.at(x, y) =
                is_background ? background_depth : float(camera_depth(stored, x, y));
        }
    return frame;
}

}  // namespace

Frame read_stored_frame(const fs::path& file, const Convention& convention, const View& view, IdChannel ids) {
    refuse_other_size(file, stored_frame_size(file, convention, ids), view);
    if (convention == Convention{}) return read_frame(file, ids);  // bit for bit
    return frame_of(read_raw_frame(file, convention), convention, view, ids);
}

Resolution stored_frame_size(const fs::path& file, const Convention& convention, IdChannel ids) {
    return convention == Convention{} ? frame_size(file, ids) : raw_frame_size(file, convention);
}

}  // namespace zproof::oracle
