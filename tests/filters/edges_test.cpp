/// At edges every surface may be shown that the promise admits, and no other.
#include <gtest/gtest.h>

#include "filters/methods/catalogue.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/selftest/filter_fault.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/filters/filter_scenes.h"

namespace zproof::selftest {
namespace {

/// Sixteen walls seen lengthwise, with the picture of a method on a frame.
class TunnelEdges : public testing::Test {
  protected:
    TunnelEdges() : loaded_(generate_filter_scene("tunnel", 256, 256)) {}

    const Scene& scene() const { return loaded_.scene; }
    const View& view() const { return loaded_.views[0]; }

    std::uint64_t outside(const Frame& frame, double displacement_px) const {
        const std::string method = "trilinear-gl";
        const Picture picture =
            rasterizer::filtered(scene(), view(), frame, {.method = *texture::find_method(method)});
        const FilterPrecision precision{.displacement_px = displacement_px};
        return conformance_of(picture, {scene(), view(), frame}, {method, {}, {}, precision}).found.outside;
    }

  private:
    Loaded loaded_;
};

TEST_F(TunnelEdges, ExactVisibilityConforms) {
    EXPECT_EQ(outside(oracle::exact_visibility(scene(), view()), 0), 0u);
}

TEST_F(TunnelEdges, ARayCasterConforms) {
    EXPECT_EQ(outside(oracle::Embree{scene()}.trace(view()), 1e-4), 0u);
}

/// Corners move by up to half of 2^-8 px, and so do edges.
TEST_F(TunnelEdges, ARasterizerOf8BitsConformsIfItSaysSo) {
    const Frame frame = rasterizer::render(scene(), view());
    EXPECT_GT(outside(frame, 0), 0u);
    EXPECT_EQ(outside(frame, 0x1p-9 + 1e-4), 0u);
}

TEST_F(TunnelEdges, AFrameThatIsMovedFurtherThanItSaysDoesNot) {
    View moved = view();
    moved.camera.window.left += 0.1 * (moved.camera.window.right - moved.camera.window.left) / moved.width;
    moved.camera.window.right += 0.1 * (moved.camera.window.right - moved.camera.window.left) / moved.width;
    const Frame frame = oracle::exact_visibility(scene(), moved);
    EXPECT_GT(outside(frame, 0.01), 0u);
    EXPECT_EQ(outside(frame, 0.11), 0u);
}

}  // namespace
}  // namespace zproof::selftest
