/// Vertices that were transformed lately: directly mapped, 64 entries, the whole index as tag.
#pragma once

#include "tests/mutants/plain/projector.h"

namespace plain {

template <class Real>
class VertexCache {
  public:
    VertexCache(const std::vector<Vec3<float>>& positions, const Projector<Real>& projector)
        : positions_(positions), projector_(projector) {
        tags_.fill(none);
    }

    const ClipVertex<Real>& operator[](std::uint32_t index) {
        const std::size_t slot = index % size;
        if (tags_[slot] != index) {
            tags_[slot] = index;
            entries_[slot] = projector_(positions_[index]);
        }
        return entries_[slot];
    }

  private:
    static constexpr std::size_t size = 64;
    static constexpr std::uint32_t none = 0xFFFF'FFFF;

    const std::vector<Vec3<float>>& positions_;
    const Projector<Real>& projector_;
    std::array<std::uint32_t, size> tags_;
    std::array<ClipVertex<Real>, size> entries_;
};

}  // namespace plain
