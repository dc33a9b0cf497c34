/// Where does the reference promise less of a triangle than the candidate? There it proves nothing that both
/// name the same triangle (docs/truth.md, "What agreement proves").
#pragma once

#include <cstdint>

#include "compare/rendered_frame.h"

namespace zproof {

class UnprovenPixels {
  public:
    explicit UnprovenPixels(const FramePair& frames);

    /// May the reference see another triangle at the pixel's centre than is there, where the candidate may
    /// not?
    bool hold(int x, int y) const { return is_unproven_.at(x, y) != 0; }
    /// The same of all pixels, 0 for no.
    const Plane<std::uint8_t>& map() const { return is_unproven_; }

  private:
    Plane<std::uint8_t> is_unproven_;
};

}  // namespace zproof
