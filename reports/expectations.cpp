#include "reports/expectations.h"
#include "frame/joined.h"

#include <algorithm>
#include <string>

namespace zproof {
namespace {

bool occurs(const std::string& class_name, const ViewResult& view) {
    for (int i = 0; i < pixel_class_count; ++i)
        if (name_of(PixelClass(i)) == class_name) return view.counts[std::size_t(i)] > 0;
    return false;
}

}  // namespace

void hold_to_expectations(std::span<ViewResult> views) {
    if (views.empty() || views.size() != views.front().scene_views) return;
    std::vector<std::string> missing;
    for (const std::string& expected : views.front().expects)
        if (std::ranges::none_of(views, [&](const ViewResult& view) { return occurs(expected, view); }))
            missing.push_back(expected);
    if (missing.empty()) return;
    views.back().outcome = Outcome::defective;
    views.back().message = "the suite expects pixels of class " + joined(missing) +
                           " in this scene, and there are none: it no longer tests what it is there for";
}

}  // namespace zproof
