// Ids and depths of a frame, beside OpenGL where a driver is there: its frame is read back, as ours is in
// memory.
#include "rasterizer/rasterizer.h"

#include "bench/lazy.h"
#include "bench/scenes.h"
#include "bench/suites.h"
#include "oracle/opengl.h"

namespace zproof::bench {
namespace {

void add_opengl_scene(const std::string& name, TimedScene (*make)()) {
    const Lazy<TimedScene> timed{make};
    const Lazy<rasterizer::Renderer> ours{[] { return rasterizer::Renderer{}; }};
    add("rasterizer/" + name + "/zproof", [=] { ours->render(timed->scene, timed->view); });
    if (oracle::opengl_is_missing()) return;
    const Lazy<oracle::OpenGl> theirs{[=] { return oracle::OpenGl{timed->scene}; }};
    add("rasterizer/" + name + "/OpenGL", [=] { benchmark::DoNotOptimize(theirs->render(timed->view)); });
}

}  // namespace

void add_rasterizer() {
    add_opengl_scene("room", room);
    add_opengl_scene("ripples", [] { return ripples(); });
    add_opengl_scene("soup", soup);
}

}  // namespace zproof::bench
