/// Which of a scene's views a shard judges.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scenes/view.h"

namespace zproof {

/// What a plan says of a scene.
struct PlannedViews {
    std::vector<std::string> all;     ///< that the scene had when the plan was made, as reports call them
    std::vector<std::size_t> wanted;  ///< places in it, ascending; of a scene without views: 0
};

/// Without a plan: the view `first`, and each stride-th after it. Every view, unless told otherwise.
struct ViewShare {
    std::size_t first = 0, stride = 1;
    std::optional<PlannedViews> planned{};

    /// Does what there is to say of a scene without views belong to this share?
    bool has_the_first() const { return planned ? planned->wanted.front() == 0 : first == 0; }
};

/// The places of the share's views among the scene's, ascending. Throws SceneError where a plan speaks of
/// other views.
std::vector<std::size_t> places_in(const ViewShare& share, const std::vector<View>& views);

}  // namespace zproof
