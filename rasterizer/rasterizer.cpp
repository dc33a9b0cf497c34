#include "rasterizer/rasterizer.h"

#include "rasterizer/pipeline.h"

namespace zproof::rasterizer {

Precision precision() {
    return RasterPrecision{.transform = Arithmetic::float64,
                           .subpixel_bits = lawful_rules.subpixel_bits,
                           .snap = Snap::nearest,
                           .interpolation = Arithmetic::float64,
                           .depth_roundings = 2};
}

Frame render(const Scene& scene, const View& view) { return render_by(lawful_rules, scene, view); }

}  // namespace zproof::rasterizer
