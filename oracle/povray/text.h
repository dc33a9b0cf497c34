/// Vectors as POV-Ray reads them.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace zproof::oracle {

/// <x,y,z>
std::string vector_text(const glm::dvec3& v);

}  // namespace zproof::oracle
