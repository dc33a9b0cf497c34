#include "cli/study/study.h"

namespace zproof {
namespace {

document::Document perform(const StudyTask& task) {
    document::Table views{.name = "views", .caption = "What was projected", .columns = {}, .rows = {}};
    views.columns = {{"view", "", ""},
                     {"width", "px", ""},
                     {"height", "px", ""},
                     {"vertices", "", "Of the baked scene."},
                     {"triangles", "", ""}};
    each_view(task, [&](const StudiedView& one) {
        task.progress.begin("vertices");
        views.rows.push_back({one.title, std::int64_t(one.view.width), std::int64_t(one.view.height),
                              std::int64_t(one.scene.vertices.position_world.size()),
                              std::int64_t(one.scene.triangles.size())});
    });
    return {.title = "The projection, stage by stage",
            .command = "",
            .version = "",
            .introduction = {},
            .sections = {{"Views", {}, {views}}}};
}

}  // namespace

Study projection_study() {
    return {.name = "projection",
            .purpose = "every stage from world to raster space, against exact arithmetic",
            .subjects = {"textured_ground"},
            .resolution = {960, 540},
            .units_per_view = 1,
            .add_options = {},
            .perform = perform};
}

}  // namespace zproof
