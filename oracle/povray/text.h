/// Vectors as POV-Ray reads them.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "frame/number_text.h"

namespace zproof::oracle {

/// <x,y,z>
inline std::string vector_text(const glm::dvec3& v) {
    return "<" + shortest(v.x) + "," + shortest(v.y) + "," + shortest(v.z) + ">";
}

}  // namespace zproof::oracle
