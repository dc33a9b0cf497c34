#include <iostream>

#include "cli/commands.h"
#include "cli/memory.h"
#include "image_io/image_io.h"
#include "program/common_arguments.h"
#include "program/companion.h"
#include "program/folder_names.h"
#include "program/interrupt.h"
#include "program/publish.h"
#include "program/samples.h"
#include "program/scene_selection.h"
#include "program/work_progress.h"
#include "rasterizer/interpolation.h"
#include "rasterizer/shader.h"
#include "renderers/registry.h"
#include "reports/notes.h"
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

/// What `zproof filters filtered` is asked; without frames, whether it understands the words.
std::vector<std::string> filtered_words(const RenderArguments& arguments,
                                        const std::filesystem::path& frames) {
    const auto& [resolution, samples, sample_word] = arguments.settings;
    std::vector<std::string> words{"filtered",  arguments.scene,
                                   "--filter",  arguments.filter,
                                   "--width",   std::to_string(resolution.width),
                                   "--height",  std::to_string(resolution.height),
                                   "--threads", std::to_string(arguments.common.threads)};
    const auto add = [&](const char* option, const std::string& word) {
        if (!word.empty()) words.insert(words.end(), {option, word});
    };
    add("--models", arguments.models.string());
    add("--sample", sample_word);
    add("--frames", frames.string());
    return words;
}

void require_done(int status) {
    if (status != 0)
        throw std::runtime_error{"the filter's program ended with status " + std::to_string(status)};
}

}  // namespace

ExitCode execute(const RenderArguments& arguments) {
    require_program(arguments.renderer);
    if (!arguments.filter.empty())
        if (const int status = status_of(*companion_named("filters"), filtered_words(arguments, {}));
            status != 0)
            return ExitCode{status};
    const SceneSource source = select_scene(arguments.scene, arguments.models);
    const Loaded loaded = load(source, arguments.settings.resolution);
    if (!arguments.common.is_quiet()) std::cerr << note_lines(source.name, loaded.scene.notes);
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
        }
    });
    bool all_written = written.size() == views.size();
    if (!arguments.filter.empty() && all_written) {
        const int status = status_of(*companion_named("filters"), filtered_words(arguments, out.working()));
        all_written = !interrupted();  // the signal was the filter's, too
        if (all_written) require_done(status);
    }
    const std::filesystem::path place =
        publish(out, arguments.common, all_written ? Completeness::full : Completeness::partial);
    if (arguments.common.is_quiet()) progress.say(std::cout, place.string() + "\n");
    for (const std::string& name : written)
        if (!arguments.common.is_quiet()) progress.say(std::cout, (place / (name + ".exr")).string() + "\n");
    if (all_written) return ExitCode::proven;
    return say_interrupted({written.size(), views.size()}, "view", "rendered and written");
}

}  // namespace zproof
