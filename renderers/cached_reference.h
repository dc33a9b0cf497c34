/// A reference that keeps its frames for other runs.
#pragma once

#include <string>

#include "oracle/reference_cache.h"
#include "renderers/registry.h"

namespace zproof {

/// As open(), but of Embree nothing is built before a frame is asked for that is not kept. Any other
/// reference is opened as it is: of what a stored frame depends on, nobody knows. Scene and cache must
/// outlive the result.
Renderer open_with_cache(const RendererChoice& choice, const Scene& scene, const std::string& scene_sha256,
                         oracle::ReferenceCache& cache);

}  // namespace zproof
