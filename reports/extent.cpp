#include "reports/extent.h"

#include "reports/wording.h"

namespace zproof {

Extent extent_of(const Results& results, const std::function<bool(const ViewResult&)>& wanted) {
    Extent extent;
    for (const ViewResult& view : results.views)
        if (wanted(view)) ++(stands_for_a_scene(view) ? extent.whole_scenes : extent.views);
    return extent;
}

Extent extent_of(const Results& results) {
    return extent_of(results, [](const ViewResult&) { return true; });
}

std::string in_words(const Extent& extent) {
    const std::string scenes = counted(extent.whole_scenes, "whole scene");
    if (extent.whole_scenes == 0) return counted(extent.views, "view");
    return extent.views == 0 ? scenes : counted(extent.views, "view") + " and " + scenes;
}

}  // namespace zproof
