/// A renderer that is asked about samples of a scene's views, a few views ahead of their use: it works, or
/// sleeps, while the views before are judged.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "renderers/registry.h"

namespace zproof {

/// The answer about one view.
struct SampledFrame {
    PixelLattice pixels;
    std::string fewer_because;  ///< as BegunSample's
    Frame frame;                ///< of view_of(pixels, view)
};

class SampledViews {
  public:
    static constexpr std::uint64_t seed = 1;

    /// Begins with the first views. The renderer has begin_sample.
    SampledViews(const Renderer& renderer, std::vector<View> views);

    /// Waits for the answer about the view at this place, and begins on views that follow. Places are asked
    /// for from low to high; the answers about those that are passed over are dropped. Throws OracleError
    /// where the renderer has none.
    SampledFrame take(std::size_t place);

  private:
    void begin_up_to(std::size_t end);

    std::function<BegunSample(const View&, std::uint64_t)> begin_sample_;
    std::vector<View> views_;
    std::size_t first_ = 0;                              ///< the place of the first that is begun
    std::deque<std::function<SampledFrame()>> begun_{};  ///< one after the other
};

}  // namespace zproof
