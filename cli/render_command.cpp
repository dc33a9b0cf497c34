#include <iostream>

#include "cli/commands.h"
#include "cli/folder_names.h"
#include "cli/interrupt.h"
#include "cli/memory.h"
#include "cli/published.h"
#include "cli/renderers/registry.h"
#include "cli/samples.h"
#include "cli/scene_selection.h"
#include "cli/threads.h"
#include "cli/work_progress.h"
#include "image_io/image_io.h"
#include "rasterizer/interpolation.h"
#include "rasterizer/shading.h"
#include "rasterizer/texturing.h"
#include "reports/output_folder.h"
#include "reports/pictures.h"
#include "scenes/judged_ranges.h"

namespace zproof {
namespace {

void write_planes(const std::filesystem::path& stem, const Frame& frame) {
    write_frame(stem.string() + ".exr", frame);
    write_png(stem.string() + "-id.png", picture_of_ids(frame.primitive));
    write_png(stem.string() + "-depth.png", picture_of_depths(frame.camera_depth));
}

void write_colours(const std::string& stem, const Picture& picture) {
    write_picture(stem + ".exr", picture);
    write_png(stem + ".png", picture_of_light(picture));
}

}  // namespace

ExitCode execute(const RenderArguments& arguments) {
    const Loaded loaded =
        load(select_scene(arguments.scene, arguments.models), arguments.settings.resolution);
    const std::vector<View> views = at_samples(loaded.views, arguments.settings.samples);
    OutputFolder out{arguments.common.out};
    note_interrupts();
    std::vector<std::string> written;
    WorkProgress progress{std::cerr, progress_beside_lines(arguments.common), double(views.size())};
    on_threads(arguments.common.threads, [&] {
        const Renderer renderer = open(arguments.renderer, loaded.scene);
        for (const View& view : views) {
            if (interrupted()) return;
            progress.begin(shown_name(view));
            written.push_back(safe_name(shown_name(view)));
            require_judged(view);
            require_memory({view.width, view.height});
            const std::filesystem::path stem = out.working() / written.back();
            Frame frame = renderer.render(view);
            if (arguments.attributes) frame.attributes = rasterizer::attributes_of(loaded.scene, view, frame);
            write_planes(stem, frame);
            write_colours(stem.string() + "-colour", rasterizer::shade(loaded.scene, view, frame, Light{}));
            if (arguments.filter)
                write_colours(stem.string() + "-filtered",
                              rasterizer::filtered(loaded.scene, view, frame, arguments.filter->texturing));
        }
    });
    const bool all_written = written.size() == views.size();
    const std::filesystem::path place =
        publish(out, arguments.common, all_written ? Completeness::full : Completeness::partial);
    if (arguments.common.is_quiet()) progress.say(std::cout, place.string() + "\n");
    for (const std::string& name : written)
        if (!arguments.common.is_quiet()) progress.say(std::cout, (place / (name + ".exr")).string() + "\n");
    if (all_written) return ExitCode::proven;
    return say_interrupted({written.size(), views.size()}, "view", "rendered and written");
}

}  // namespace zproof
