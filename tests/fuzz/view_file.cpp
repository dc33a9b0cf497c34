// A view file beside the model that it names.
#include "scenes/view_file.h"

#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"
#include "scenes/view_document.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {
namespace {

constexpr std::string_view model =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
    R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
    R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

void require_same_views(const std::vector<View>& views, const ScratchFolder& folder) {
    const std::string text = view_document("model.gltf", views);
    const Loaded again = load_view_file(folder.write("again.view.json", text));
    require(view_document("model.gltf", again.views) == text, "a written view file gives back its views");
}

}  // namespace

void read_input(Input input) {
    static const ScratchFolder folder;
    static const auto model_file = folder.write("model.gltf", model);
    const auto file = folder.write("input.view.json", input);
    std::vector<View> views;
    may_refuse<SceneError>([&] { views = load_view_file(file).views; });
    if (views.empty()) return;
    require_same_views(views, folder);
    for (const View& view : views) may_refuse<SceneError>([&] { require_judged(view); });
}

}  // namespace zproof::fuzz
