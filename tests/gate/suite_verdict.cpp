#include "tests/gate/suite_verdict.h"

#include "oracle/embree.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof {

std::vector<SuiteVerdict> try_suite_scene(const std::string& scene, int width, int height,
                                          const rasterizer::Rules& rules) {
    const Loaded loaded = generate_suite_scene(scene, width, height);
    const oracle::Embree embree(loaded.scene);
    std::vector<SuiteVerdict> suite_verdicts;
    for (const View& view : loaded.views) {
        const Frame candidate = rasterizer::render_by(rules, loaded.scene, view);
        const Frame reference = embree.trace(view);
        suite_verdicts.push_back(
            {scene + "/" + view.name, judge(loaded.scene, view, {candidate, rasterizer::precision()},
                                            {reference, oracle::embree_precision()})});
    }
    return suite_verdicts;
}

PixelClass commonest_defect(const Verdict& verdict) {
    PixelClass commonest = PixelClass::agree;
    std::uint64_t most = 0;
    for (int c = 0; c < pixel_class_count; ++c) {
        const std::uint64_t count = verdict.counts[std::size_t(c)];
        if (passes(PixelClass(c)) || count <= most) continue;
        most = count;
        commonest = PixelClass(c);
    }
    return commonest;
}

}  // namespace zproof
