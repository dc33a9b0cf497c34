// The command that reads other programs' cameras: views.
#include "cli/command_line/branches.h"
#include "cli/command_line/options.h"
#include "cli/commands.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr const char* views_remark =
    "\nExit status: 0 written, 3 a file that cannot be read, or a camera that is no pinhole.";

const std::map<std::string, CameraSource> camera_sources{
    {"opencv", CameraSource::opencv}, {"colmap", CameraSource::colmap}, {"nerf", CameraSource::nerf}};

}  // namespace

Branch add_views(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("views", "a view file from OpenCV's, COLMAP's or NeRF's cameras");
    ViewsArguments& views = words.views;
    add_choice(app, "SOURCE", views.source, camera_sources)
        ->required()
        ->default_str("")
        ->description("whose cameras: opencv, colmap or nerf");
    app.add_option("CAMERAS", views.cameras,
                   "opencv: JSON with K, R and t; colmap: the folder of cameras.txt and images.txt; nerf: "
                   "transforms.json")
        ->required();
    app.add_option("MODEL", views.model, "the model that is seen: .gltf, .glb, .obj or .ply")->required();
    add_common(app, views.common, "the view file, in the model's folder or above it");
    app.get_option("--out")->required();
    app.add_option("--near", views.range.near_depth, "camera depth of the near plane")
        ->required()
        ->check(CLI::PositiveNumber);
    app.add_option("--far", views.range.far_depth, "camera depth of the far plane; without it, none")
        ->check(CLI::PositiveNumber);
    app.add_option("--width", words.image_size.x,
                   "of nerf: the images' width, where the file does not say it")
        ->check(CLI::Range(1, 16384));
    app.add_option("--height", words.image_size.y, "of nerf: the images' height")
        ->check(CLI::Range(1, 16384));
    app.footer(views_remark);
    return {&app, [&words] {
                const glm::ivec2 size = words.image_size;
                if ((size.x == 0) != (size.y == 0))
                    throw UsageError{"views: --width and --height are given together"};
                if (size.x > 0) words.views.image_size = size;
                return command_of(words.views, "cannot import the views");
            }};
}

}  // namespace zproof
