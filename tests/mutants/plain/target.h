/// The picture while it is drawn, with its depth buffer.
#pragma once

#include <utility>

#include "tests/mutants/plain/depth_code.h"

namespace plain {

class Target {
  public:
    Target(const Camera& camera, DepthBuffer buffer)
        : picture_(camera.width, camera.height),
          code_(camera, buffer),
          stored_(picture_.ids.size(), -std::numeric_limits<float>::infinity()) {}

    void draw(int x, int y, float z, std::uint32_t id) {
        const std::size_t at = picture_.at(x, y);
        const float stored = code_.stored(z);
        if (stored <= stored_[at]) return;
        stored_[at] = stored;
        picture_.ids[at] = id;
    }

    Picture finished() {
        for (std::size_t i = 0; i < stored_.size(); ++i)
            if (picture_.ids[i] != background) picture_.depths[i] = code_.camera_depth(stored_[i]);
        return std::move(picture_);
    }

  private:
    Picture picture_;
    DepthCode code_;
    std::vector<float> stored_;
};

}  // namespace plain
