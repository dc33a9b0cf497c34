/// Stories and names as the viewer reads them.
#pragma once

#include <nlohmann/json.hpp>

#include "reports/planes/view_planes.h"

namespace zproof::planes {

/// [{"x", "y", "class", "text", "eps", "reference_eps", "background", "candidates", "images"}, ...]; lengths
/// of images are rounded to float, which no drawing shows.
nlohmann::json to_json(const std::vector<Story>& stories);

/// [[first, count, node, mesh, primitive], ...]
nlohmann::json to_json(const std::vector<TriangleRange>& ranges);

}  // namespace zproof::planes
