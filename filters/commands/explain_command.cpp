#include <algorithm>
#include <iostream>

#include "filters/commands/commands.h"
#include "filters/commands/study_method.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/report/inspection_words.h"
#include "frame/number_text.h"
#include "program/common_arguments.h"
#include "program/study_scenes.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

View view_of(const Loaded& loaded, const FiltersExplainArguments& arguments) {
    const View view = chosen_views(loaded, {arguments.view}).front();
    const PixelCoord& pixel = arguments.pixel;
    if (pixel.x < view.width && pixel.y < view.height) return view;
    throw UsageError{"--pixel: the view has " + size_text(view.width, view.height) +
                     " pixels, from 0,0; found " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) +
                     " (--width, --height)"};
}

/// What the picture has at the pixel, beside what its claim permits there.
ClaimedPixel claimed_pixel(const FiltersExplainArguments& arguments, const Scene& scene, const View& view) {
    const auto& [x, y] = arguments.pixel;
    const LinearRgb value = picture_in(arguments.picture, view).at(x, y);
    return {.method = arguments.claim.method.typed,
            .promise = arguments.claim.promise,
            .value = value,
            .permitted = permitted_at(arguments.claim.claim, {x, y}, value, scene, view)};
}

}  // namespace

ExitCode execute(const FiltersExplainArguments& arguments) {
    const StudyScene source = study_scenes({arguments.scene}).front();
    const Loaded loaded = load(source, {arguments.width, arguments.height}, arguments.common);
    const View view = view_of(loaded, arguments);
    std::vector<study::StudyMethod> methods;
    for (const FilterChoice& choice : arguments.methods) methods.push_back(study_method(choice));
    std::optional<ClaimedPixel> claimed;
    on_threads(arguments.common.threads, [&] {
        if (!arguments.picture.empty()) claimed = claimed_pixel(arguments, loaded.scene, view);
        const Frame frame = oracle::exact_visibility(loaded.scene, view);
        const study::Inspector inspector(loaded.scene, view, frame, arguments.truth);
        for (const study::StudyMethod& method : methods) {
            const study::PixelInspection one = inspector.at(method, {arguments.pixel}).front();
            std::cout << (arguments.common.is_quiet() ? in_a_line(one) : in_words(one));
        }
        if (claimed) std::cout << (arguments.common.is_quiet() ? in_a_line(*claimed) : in_words(*claimed));
    });
    return claimed && is_outside(*claimed) ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
