/// A plain renderer of several kinds, as a stranger writes it who knows docs/renderer-contract.md and no more
/// of zproof.
#pragma once

#include <span>
#include <string_view>

#include "tests/mutants/plain/mesh.h"

namespace plain {

/// A kind of renderer, and what it promises, in the words of --precision.
struct Mode {
    std::string_view name, precision;
    Picture (*render)(const Mesh& mesh, const Camera& camera);
};

std::span<const Mode> modes();

}  // namespace plain
