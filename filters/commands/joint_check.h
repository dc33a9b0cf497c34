/// A picture held against its promise as a whole (docs/joint-conformance.md).
#pragma once

#include <string>

#include "filters/conformance/joint_conformance.h"
#include "filters/selftest/filter_fault.h"

namespace zproof {

/// For any number of pictures of one view. The fixture must outlive it; the method must have a filter
/// reference.
JointCheck joint_check_of(const selftest::FilterFixture& fixture, const selftest::FilterClaim& claim);

/// Offsets of LOD, of the place on the texture in u and in v, and gain. The method must have a filter
/// reference.
JointConformance joint_conformance_of(const Picture& picture, const selftest::FilterFixture& fixture,
                                      const selftest::FilterClaim& claim);

/// "offsets promised within: LOD 2.1 levels, u 1.5 texels, ..."; of a picture of which nothing is proved.
std::string promised_in_words(const JointConformance& found);

/// A line for each offset, and for each alternative that is nearer than the definition.
std::vector<std::string> in_words(const JointConformance& found);

}  // namespace zproof
