/// A picture held against its promise as a whole (docs/joint-conformance.md).
#pragma once

#include <string>

#include "filters/conformance/joint_conformance.h"
#include "filters/selftest/filter_fault.h"

namespace zproof {

/// Offsets of LOD, of the place on the texture in u and in v, and gain. The method must have a filter
/// reference.
JointConformance joint_conformance_of(const Picture& picture, const selftest::FilterFixture& fixture,
                                      const selftest::FilterClaim& claim);

/// A line for each offset, and for each alternative that is nearer than the definition.
std::vector<std::string> in_words(const JointConformance& found);

}  // namespace zproof
