// Your renderer before the judge: fill a Frame, say what your arithmetic promises, read the verdict.
//
//   judge_your_frame model.glb
#include <cstdlib>
#include <exception>
#include <iostream>

#include "compare/explanation/explain.h"
#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/gltf.h"

namespace {

/// Put your renderer here. For pixel (x, y) it answers with the index of the triangle that it sees through
/// the pixel centre, and that point's distance along the view axis; background keeps PrimitiveId::none and
/// +infinity.
zproof::Frame your_renderer(const zproof::Scene& scene, const zproof::View& view) {
    zproof::Frame frame = zproof::rasterizer::render(scene, view);
    frame.primitive.at(view.width / 2, view.height / 2) = zproof::PrimitiveId{0};  // and a bug, to see one
    return frame;
}

/// A float32 transform, vertices snapped to 1/256 pixel, depth interpolated in float32: what most GPUs do.
constexpr zproof::RasterPrecision your_precision{.transform = zproof::Arithmetic::float32,
                                                 .subpixel_bits = 8,
                                                 .snap = zproof::Snap::nearest,
                                                 .interpolation = zproof::Arithmetic::float32,
                                                 .depth_roundings = 2};

std::uint64_t defects_in(const zproof::Scene& scene, const zproof::View& view) {
    const zproof::Frame candidate = your_renderer(scene, view);
    const zproof::Frame reference = zproof::oracle::Embree{scene}.trace(view);
    const zproof::Verdict verdict = zproof::judge(scene, view, {candidate, your_precision},
                                                  {reference, zproof::oracle::embree_precision()});
    for (const zproof::Finding& finding : verdict.findings)
        if (!zproof::passes(finding.verdict))
            std::cout << view.name << " (" << finding.x << ", " << finding.y
                      << "): " << zproof::in_words(scene, finding) << "\n";
    return zproof::defect_count(verdict);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::cerr << "usage: judge_your_frame model.glb\n", 2;
    try {
        const zproof::Loaded loaded = zproof::load_gltf(argv[1]);
        std::uint64_t defects = 0;
        for (const zproof::View& view : loaded.views) defects += defects_in(loaded.scene, view);
        std::cout << defects << " defects\n";
        return defects == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& e) {
        std::cerr << "judge_your_frame: " << e.what() << "\n";
        return 3;
    }
}
