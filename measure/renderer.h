/// A renderer as it can be measured: its name, what it does, and what it says it does.
#pragma once

#include <functional>
#include <string>

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::measure {

struct Renderer {
    std::string name;
    std::function<Frame(const Scene&, const View&)> render;
    Precision declared;
};

}  // namespace zproof::measure
