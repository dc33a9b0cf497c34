#include "selftest/test_scene.h"

#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof::selftest {

Resolution resolution_of(FixtureSize size) {
    return size == FixtureSize::large ? Resolution{.width = 1920, .height = 1080}
                                      : Resolution{.width = 160, .height = 90};
}

TestScene::TestScene(FixtureSize size)
    : loaded_(generate_suite_scene(fixture_scene, resolution_of(size).width, resolution_of(size).height)),
      good_(rasterizer::render(loaded_.scene, loaded_.views.front())),
      reference_(oracle::Embree(loaded_.scene).trace(loaded_.views.front())) {}

Fixture TestScene::fixture() const {
    return {loaded_.scene, loaded_.views.front(),   good_,
            reference_,    rasterizer::precision(), oracle::embree_precision()};
}

}  // namespace zproof::selftest
