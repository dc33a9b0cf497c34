/// What a wrong picture is the right picture of: definitions that differ from the claimed one by one thing
/// are tried, and named where they permit every pixel (docs/filter-conformance.md, "Causes").
#pragma once

#include "filters/selftest/changed_definition.h"

namespace zproof::selftest {

/// What is tried, the likeliest first.
std::vector<DefinitionChange> likely_changes(const Scene& scene, const FilterClaim& claim);

/// The names of those changes under which every pixel is permitted; pixels that are outside are asked first.
/// Not told is one that permits errors of the other sign as well, or far more than another one that explains
/// the picture. Nothing where none is outside. On the threads of the surrounding tbb::task_arena.
std::vector<std::string> causes_of(const Picture& picture, const ChangedDefinitions& definitions,
                                   const FilterClaim& claim, const Conformance& found,
                                   const std::vector<DefinitionChange>& changes);

/// "; cause: LOD half a level too high"; nothing without one.
std::string causes_in_words(const std::vector<std::string>& causes);

}  // namespace zproof::selftest
