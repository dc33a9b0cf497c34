/// Most pixels at which surfaces tie lie far from every edge; they are decided by depths alone.
#pragma once

#include <optional>

#include "compare/truth/standing.h"

namespace zproof {

/// The standing of an answer where every triangle certainly covers the whole square, or certainly misses it,
/// and none is near a clip plane, as AdmissibleSet would decide it. Nothing where double precision cannot
/// tell, or where the answer is not simply visible or tied.
std::optional<Standing> standing_without_edges(const Neighbourhood& around, PrimitiveId answer,
                                               CoplanarMemory& memory);

}  // namespace zproof
