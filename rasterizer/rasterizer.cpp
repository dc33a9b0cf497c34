#include "rasterizer/rasterizer.h"

#include "rasterizer/pipeline.h"

namespace zproof::rasterizer {

Precision precision() {
    return RasterPrecision{.transform = Arithmetic::float64,
                           .subpixel_bits = correct_rules.subpixel_bits,
                           .snap = Snap::nearest,
                           .interpolation = Arithmetic::float64,
                           .depth_roundings = 2};
}

Renderer::Renderer() : pipeline_(std::make_unique<Pipeline>(correct_rules)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Frame& Renderer::render(const Scene& scene, const View& view) { return pipeline_->render(scene, view); }

Frame render(const Scene& scene, const View& view) { return render_by(correct_rules, scene, view); }

}  // namespace zproof::rasterizer
