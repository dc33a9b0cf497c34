/// Where does the reference promise less than the candidate? There it proves nothing that both name the same
/// triangle (docs/truth.md, "What agreement proves").
#pragma once

#include <vector>

#include "compare/adjudicate/tiles.h"
#include "compare/rendered_frame.h"

namespace zproof {

class CoarseTiles {
  public:
    explicit CoarseTiles(const FramePair& frames);

    bool has_any() const { return has_any_; }
    /// May the reference displace a triangle near the pixel farther than the candidate may?
    bool hold(int x, int y) const { return is_coarse_[tiles_.of(x, y)]; }

  private:
    void mark(const FramePair& frames, std::uint32_t triangle);

    Tiles tiles_;
    std::vector<bool> is_coarse_;  ///< by tile
    bool has_any_ = false;
};

}  // namespace zproof
