#include "oracle/povray/text.h"

#include "frame/number_text.h"

namespace zproof::oracle {

std::string vector_text(const glm::dvec3& v) {
    std::string text = "<";
    text.append(shortest(v.x)).append(",");
    text.append(shortest(v.y)).append(",");
    return text.append(shortest(v.z)).append(">");
}

}  // namespace zproof::oracle
