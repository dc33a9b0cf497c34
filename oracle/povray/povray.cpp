#include "oracle/povray.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "oracle/centre_only.h"
#include "oracle/oracle_error.h"
#include "oracle/povray/picture.h"
#include "oracle/povray/scene.h"
#include "oracle/scratch_folder.h"
#include "oracle/subprocess.h"

namespace zproof::oracle {
namespace {

constexpr const char *scene_file = "scene.pov", *picture_file = "picture.png";

/// One ray through each pixel's centre, 16 bits per channel as computed: no window, no dither, no gamma.
std::vector<std::string> arguments(const std::string& program, const View& view, int threads) {
    return {program,
            std::string("+I") + scene_file,
            std::string("+O") + picture_file,
            "+FN16",
            "+W" + std::to_string(view.width),
            "+H" + std::to_string(view.height),
            "+WT" + std::to_string(threads),
            "File_Gamma=1.0",
            "Dither=off",
            "-A",
            "-D",
            "-P",
            "-C",
            "-V"};
}

void require_success(const Outcome& outcome, const View& view, std::chrono::milliseconds time_limit) {
    if (outcome.succeeded()) return;
    // a picture that takes too long is no error of POV-Ray's, and it has nothing to say but how far it came
    const std::string said = outcome.ending == Ending::timed_out ? "" : "; it said: " + last_output(outcome);
    throw OracleError("POV-Ray, view '" + view.name + "': " + in_words(outcome, time_limit) + said);
}

Plane<Rgb16> drawn(const std::filesystem::path& folder, const View& view) {
    try {
        return read_rgb16(folder / picture_file, {view.width, view.height});
    } catch (const FrameError& e) {
        throw OracleError("POV-Ray, view '" + view.name + "': " + e.what());
    }
}

/// POV-Ray at work in a folder that holds the view's scene file; the result waits for its picture.
std::function<Plane<Rgb16>()> started(const PovRayOptions& options, const View& view, int threads,
                                      std::shared_ptr<const ScratchFolder> folder) {
    const Command command{.arguments = arguments(options.program, view, threads),
                          .folder = folder->path(),
                          .time_limit = options.time_limit};
    return [view, folder, time_limit = options.time_limit, outcome_of = start(command)] {
        require_success(outcome_of(), view, time_limit);
        return drawn(folder->path(), view);
    };
}

Frame frame_of(const Plane<PovrayCode::Channels>& picture, const PovrayScene& scene) {
    Frame frame(picture.size());
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const PovrayCode::Pixel pixel = scene.code.decoded(picture.pixels()[i]);
        frame.primitive.pixels()[i] = pixel.primitive;
        frame.camera_depth.pixels()[i] = static_cast<float>(pixel.depth / scene.scale);
    }
    return frame;
}

Picture colours_of(const Plane<PovrayCode::Channels>& codes) {
    Picture picture(codes.size());
    std::ranges::transform(codes.pixels(), picture.pixels().begin(), [](const PovrayCode::Channels& c) {
        return LinearRgb{float(c[0]) / 65535, float(c[1]) / 65535, float(c[2]) / 65535};
    });
    return picture;
}

}  // namespace

Frame PovRay::render(const View& view) const {
    return begin(view, tbb::this_task_arena::max_concurrency())();
}

std::function<Frame()> PovRay::begin(const View& view, int threads) const {
    require_centre(view, "POV-Ray");
    const auto scratch = std::make_shared<const ScratchFolder>();
    PovrayScene scene = povray_scene(scene_, view);
    scratch->write(scene_file, std::exchange(scene.text, ""));
    return
        [scene, picture = started(options_, view, threads, scratch)] { return frame_of(picture(), scene); };
}

Picture PovRay::picture(const View& view, const Light& light, const PhongFinish& phong_finish) const {
    require_centre(view, "POV-Ray");
    const auto scratch = std::make_shared<const ScratchFolder>();
    const PovrayPicture picture = povray_picture(scene_, view, light, phong_finish);
    scratch->write(scene_file, picture.text);
    for (const PovrayImage& image : picture.images) scratch->write(image.name, image.bytes);
    return colours_of(started(options_, view, tbb::this_task_arena::max_concurrency(), scratch)());
}

Precision povray_precision() {
    return PlaneRayPrecision{
        .aim_offset_px = 0x1p-28,
        .least_corner_sine = 0x1p-26,
        .least_grazing_sine = 1e-10,
        .depth_relative = 0x1.0001p-23,  // half a step of the code, and float32's rounding
        .depth_of_range = 0x1.0001p-29,
        .clip_relative = 0x1p-23,
        .clip_of_reach = 0x1p-41};
}

std::optional<std::string> povray_version(const std::string& program) {
    try {
        const Outcome outcome =
            run({.arguments = {program, "--version"}, .time_limit = std::chrono::seconds(30)});
        const std::string said = outcome.output + outcome.error_output;
        const std::size_t at = said.find("POV-Ray ");
        return at == std::string::npos ? program : said.substr(at, said.find('\n', at) - at);
    } catch (const OracleError&) {
        return std::nullopt;
    }
}

}  // namespace zproof::oracle
