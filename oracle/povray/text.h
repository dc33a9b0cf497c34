/// Numbers as POV-Ray reads them.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace zproof::oracle {

/// The shortest decimal that reads back as this very double. It must be finite.
std::string number_text(double number);

/// <x,y,z>
std::string vector_text(const glm::dvec3& v);

}  // namespace zproof::oracle
