#include "cli/selftest/theatre.h"

#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof::selftest {

Resolution resolution_of(StageSize size) {
    return size == StageSize::large ? Resolution{.width = 1920, .height = 1080}
                                    : Resolution{.width = 160, .height = 90};
}

Theatre::Theatre(StageSize size)
    : loaded_(generate_suite_scene(stage_scene, resolution_of(size).width, resolution_of(size).height)),
      good_(rasterizer::render(loaded_.scene, loaded_.views.front())),
      reference_(oracle::Embree(loaded_.scene).trace(loaded_.views.front())) {}

Stage Theatre::stage() const {
    return {loaded_.scene, loaded_.views.front(),   good_,
            reference_,    rasterizer::precision(), oracle::embree_precision()};
}

}  // namespace zproof::selftest
