/// One part of the scene that stands elsewhere than it should.
#pragma once

#include <memory>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// The only part of which one of the frames shows something at every pixel whose ids differ. Nothing where
/// there are several, where the scene has no other, or where the candidate names no triangles.
const Part* only_part_that_differs(const DiagnosisInput& input);

/// The scene with the part where `declared` sees it as `fitted` does where it is.
std::shared_ptr<const Scene> with_part_moved(const Scene& scene, const Part& part, const Camera& declared,
                                             const Camera& fitted);

}  // namespace zproof
