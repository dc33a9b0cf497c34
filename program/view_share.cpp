#include "program/view_share.h"

#include <algorithm>
#include <iterator>

#include "program/samples.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

std::vector<std::string> shown_names(const std::vector<View>& views) {
    std::vector<std::string> names;
    std::ranges::transform(views, std::back_inserter(names), shown_name);
    return names;
}

}  // namespace

std::vector<std::size_t> places_in(const ViewShare& share, const std::vector<View>& views) {
    if (share.planned) {
        if (share.planned->all != shown_names(views))
            throw SceneError{
                "the scene has other views than the plan says: it was changed; make the plan again"};
        return share.planned->wanted;
    }
    std::vector<std::size_t> places;
    for (std::size_t i = share.first; i < views.size(); i += share.stride) places.push_back(i);
    return places;
}

}  // namespace zproof
