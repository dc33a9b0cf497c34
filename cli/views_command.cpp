#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "frame/input_file.h"
#include "frame/printable.h"
#include "frame/whole_file.h"
#include "scenes/import/view_import.h"
#include "scenes/scene_error.h"
#include "scenes/view_document.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

ImportedViews import_views(const ViewsArguments& arguments) {
    switch (arguments.source) {
        case CameraSource::opencv:
            return {import_opencv(arguments.cameras, arguments.range)};
        case CameraSource::colmap:
            return import_colmap(arguments.cameras, arguments.range);
        case CameraSource::nerf:
            break;
    }
    return {import_nerf(arguments.cameras, arguments.range, arguments.image_size)};
}

/// The model's path as a view file names it.
std::string model_from(const fs::path& view_file, const fs::path& model) {
    if (const std::string fault = fault_of_input(model); !fault.empty())
        throw SceneError{model.string() + ": " + fault +
                         "; expected the model that the cameras see: a .gltf, .glb, .obj or .ply file"};
    const fs::path path =
        fs::canonical(model).lexically_relative(fs::weakly_canonical(fs::absolute(view_file)).parent_path());
    if (path.empty() || *path.begin() == "..")
        throw SceneError{view_file.string() +
                         ": a view file stands in its model's folder or above it; expected -o " +
                         (model.parent_path() / view_file.filename()).string()};
    return path.generic_string();
}

Adjustment largest_adjustment(const std::vector<ImportedView>& views) {
    Adjustment largest;
    for (const auto& [view, adjustment] : views) {
        largest.eye = std::max(largest.eye, adjustment.eye);
        largest.axes = std::max(largest.axes, adjustment.axes);
    }
    return largest;
}

}  // namespace

ExitCode execute(const ViewsArguments& arguments) {
    const std::string model = model_from(arguments.common.out, arguments.model);
    const auto [imported, left_out] = import_views(arguments);
    std::vector<View> views;
    for (const ImportedView& one : imported) views.push_back(one.view);
    if (!arguments.common.is_quiet())
        for (const std::string& images : left_out) std::cerr << "zproof: " << images << "\n";
    write_whole_file(arguments.common.out, view_document(model, views));
    const Adjustment largest = largest_adjustment(imported);
    std::cout << one_line(arguments.common.out.string()) << ": " << views.size()
              << (views.size() == 1 ? " view" : " views") << "; eyes moved by at most " << largest.eye
              << " (they are float32), axes by at most " << largest.axes << " (they are orthonormal)\n";
    return ExitCode::proven;
}

}  // namespace zproof
