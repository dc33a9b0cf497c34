#include "filters/commands/commands.h"
#include "image_io/image_io.h"
#include "program/common_arguments.h"
#include "program/folder_names.h"
#include "program/interrupt.h"
#include "program/samples.h"
#include "program/scene_selection.h"
#include "reports/pictures.h"

namespace zproof {

ExitCode execute(const FiltersFilteredArguments& arguments) {
    if (arguments.frames.empty()) return ExitCode::proven;
    const Loaded loaded = load(select_scene(arguments.scene, arguments.models), arguments.resolution);
    on_threads(arguments.common.threads, [&] {
        for (const View& view : at_samples(loaded.views, arguments.samples)) {
            const std::string stem = (arguments.frames / safe_name(shown_name(view))).string();
            if (interrupted() || !std::filesystem::exists(stem + ".exr")) continue;
            const Picture picture = rasterizer::filtered(loaded.scene, view, read_frame(stem + ".exr"),
                                                         arguments.filter->texturing);
            write_picture(stem + "-filtered.exr", picture);
            write_png(stem + "-filtered.png", picture_of_light(picture));
        }
    });
    return ExitCode::proven;
}

}  // namespace zproof
