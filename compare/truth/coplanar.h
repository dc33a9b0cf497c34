#pragma once

#include <cstdint>

#include "compare/bounds/bounds.h"
#include "compare/memory.h"

namespace zproof {

/// Do both triangles lie in one plane, exactly?
bool coplanar(const CornersWorld& a, const CornersWorld& b);

/// Do three points lie on one line, exactly? True where two of them are the same.
bool collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Remembers answers to coplanar(). One thread at a time.
class CoplanarMemory {
  public:
    /// A triangle, and the id that tells it from all others.
    struct Triangle {
        std::uint32_t id;
        const CornersWorld& p_world;
    };

    /// Of so many pairs.
    explicit CoplanarMemory(std::size_t pairs) : of_pair_(pairs) {}

    bool operator()(const Triangle& a, const Triangle& b) {
        return of_pair_(std::uint64_t{a.id} << 32 | b.id, [&] { return coplanar(a.p_world, b.p_world); });
    }

  private:
    Memory<std::uint64_t, bool> of_pair_;
};

}  // namespace zproof
