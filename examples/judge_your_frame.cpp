// Your renderer before the judge: fill two arrays, say what your arithmetic promises, read the verdict. It
// needs zproof/zproof.h alone (docs/api.md).
//
//   judge_your_frame model.glb [REPORT_FOLDER]
#include <cstdlib>
#include <exception>
#include <iostream>
#include <vector>

#include "zproof/zproof.h"

namespace {

namespace zp = zproof::api;

struct Arrays {
    std::vector<std::uint32_t> id;
    std::vector<float> depth;
};

/// Put your renderer here. For pixel (x, y) it answers with the index of the triangle that it sees through
/// the pixel centre, and that point's distance along the view axis; background is zp::background_id and
/// +infinity.
Arrays your_renderer(const zp::Scene& scene, const zp::View& view) {
    const zp::Frame frame = zp::render(scene, view);
    Arrays arrays{{frame.id().begin(), frame.id().end()}, {frame.depth().begin(), frame.depth().end()}};
    const auto [width, height] = view.size();
    arrays.id[std::size_t(height / 2 * width + width / 2)] = 0;  // and a bug, to see one
    return arrays;
}

/// A float32 transform, vertices snapped to 1/256 pixel, depth interpolated in float32: what most GPUs do.
constexpr const char* your_precision =
    "raster,transform=float32,subpixel_bits=8,snap=nearest,interpolation=float32,depth_roundings=2";

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) return std::cerr << "usage: judge_your_frame model.glb [REPORT_FOLDER]\n", 2;
    try {
        const zp::Scene scene = zp::Scene::load(argv[1]);
        std::vector<Arrays> frames;  // a verdict refers to them
        frames.reserve(scene.views().size());
        std::vector<zp::NamedVerdict> verdicts;
        std::uint64_t defects = 0;
        for (const zp::View& view : scene.views()) {
            const Arrays& frame = frames.emplace_back(your_renderer(scene, view));
            const zp::Verdict verdict =
                zp::judge(scene, view, {.id = frame.id, .depth = frame.depth, .precision = your_precision});
            if (const auto worst = verdict.worst())
                std::cout << view.name() << ": " << verdict.explain(worst->x, worst->y).text;
            defects += verdict.defect_count();
            verdicts.push_back({scene.name() + "-" + view.name(), verdict});
        }
        std::cout << defects << " defects\n";
        if (argc == 3) zp::save(verdicts, argv[2]);
        return defects == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& e) {
        std::cerr << "judge_your_frame: " << e.what() << "\n";
        return 3;
    }
}
