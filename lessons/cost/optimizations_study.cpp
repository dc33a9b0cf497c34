#include "lessons/cost/optimizations_study.h"

#include <algorithm>
#include <array>
#include <bit>
#include <deque>
#include <functional>
#include <map>

#include "compare/judge.h"
#include "math/processor.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "rasterizer/shader.h"

namespace zproof::study::cost {
namespace {

using namespace rasterizer;

constexpr Optimizations plain{.hierarchical_z = HierarchicalZ::none};

struct Named {
    const char* name;
    Optimizations optimizations;
};

constexpr Optimizations all_optimizations{Facing::front, HierarchicalZ::blocks, FrustumCulling::chunks,
                                          DrawOrder::chunks_front_to_back};

/// Each by itself on the plain z-buffer; together with and without back faces, which need a closed mesh.
constexpr std::array named_optimizations{
    Named{"plain z-buffer", plain},
    Named{"back-face culling", {.facing = Facing::front, .hierarchical_z = HierarchicalZ::none}},
    Named{"frustum culling",
          {.hierarchical_z = HierarchicalZ::none, .frustum_culling = FrustumCulling::chunks}},
    Named{"front to back", {.hierarchical_z = HierarchicalZ::none, .order = DrawOrder::chunks_front_to_back}},
    Named{"hierarchical z", {.order = DrawOrder::as_stored}},
    Named{"hierarchical z, nearest first", {.order = DrawOrder::front_to_back}},
    Named{"hierarchical z, front to back", {.order = DrawOrder::chunks_front_to_back}},
    Named{"all but back faces",
          {.frustum_culling = FrustumCulling::chunks, .order = DrawOrder::chunks_front_to_back}},
    Named{"all", all_optimizations},
};

using Position = std::array<float, 3>;
using Edge = std::pair<Position, Position>;

/// -0 and 0 are one place.
Position place_of(const glm::vec3& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

struct Sames {
    bool id, depth;
};

Sames sames_at(std::size_t pixel, const Frame& a, const Frame& b) {
    return {a.primitive.pixels()[pixel] == b.primitive.pixels()[pixel],
            same_bits(a.camera_depth.pixels()[pixel], b.camera_depth.pixels()[pixel])};
}

/// The pixels in which two frames differ, beside the defects of one.
Sameness differing(const Frame& a, const Frame& b, std::uint64_t defects) {
    Sameness same{.defects = defects};
    for (std::size_t i = 0; i < a.primitive.pixels().size(); ++i) {
        const auto [id, depth] = sames_at(i, a, b);
        same.other_ids += id ? 0 : 1;
        same.other_depths += depth ? 0 : 1;
    }
    return same;
}

/// Knows the plain frame, and asks the judge once about what several frames show alike at a pixel.
class Gate {
  public:
    Gate(const Scene& scene, const View& view, const Frame& plain_frame)
        : scene_(scene), view_(view), plain_(plain_frame), reference_(oracle::Embree(scene).trace(view)) {
        defects_of(plain_frame);
    }

    Sameness ask(const Frame& frame) { return differing(frame, plain_, defects_of(frame)); }

  private:
    struct Asked {
        Frame frame;
        Plane<PixelClass> classes;
    };

    /// The earlier frame that shows the same at a pixel; null where none does.
    std::vector<const Asked*> asked_alike(const Frame& frame) const {
        std::vector<const Asked*> alike(frame.primitive.pixels().size());
        for (std::size_t i = 0; i < alike.size(); ++i)
            for (const Asked& asked : asked_)
                if (const auto [id, depth] = sames_at(i, asked.frame, frame); id && depth) alike[i] = &asked;
        return alike;
    }

    /// Right only at pixels without an earlier frame: elsewhere what the reference shows is judged.
    Plane<PixelClass> judged(Frame frame, const std::vector<const Asked*>& alike) const {
        for (std::size_t i = 0; i < alike.size(); ++i) {
            if (!alike[i]) continue;
            frame.primitive.pixels()[i] = reference_.primitive.pixels()[i];
            frame.camera_depth.pixels()[i] = reference_.camera_depth.pixels()[i];
        }
        return judge(scene_, view_, {frame, rasterizer::precision()},
                     {reference_, oracle::embree_precision()})
            .classes;
    }

    std::uint64_t defects_of(const Frame& frame) {
        const std::vector<const Asked*> alike = asked_alike(frame);
        const bool is_known = std::ranges::count(alike, nullptr) == 0;
        Plane<PixelClass> classes = is_known ? Plane<PixelClass>(frame.size()) : judged(frame, alike);
        for (std::size_t i = 0; i < alike.size(); ++i)
            if (alike[i]) classes.pixels()[i] = alike[i]->classes.pixels()[i];
        const auto defects = std::uint64_t(std::ranges::count_if(classes.pixels(), is_defect));
        asked_.push_back({frame, std::move(classes)});
        return defects;
    }

    const Scene& scene_;
    const View& view_;
    const Frame& plain_;
    Frame reference_;
    std::deque<Asked> asked_;
};

/// Every optimization's work counted, and all of them timed in turn.
std::vector<OptimizationRun> optimization_runs(const Scene& scene, const View& view, int repeats) {
    const std::vector<Chunk> chunks = chunks_of(scene);
    std::vector<OptimizationRun> runs;
    std::deque<Pipeline> pipelines;
    std::vector<std::function<void()>> works;
    for (const Named& named : named_optimizations) {
        Pipeline& pipeline = pipelines.emplace_back(correct_rules, widest_of(kernels), named.optimizations);
        runs.push_back({named.name, named.optimizations, pipeline.count_work(scene, view, chunks), {}, {}});
        works.emplace_back([&] { pipeline.render(scene, view, chunks); });
    }
    const std::vector<Timing> timings = timed_in_turn(repeats, works);
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].timing = timings[i];
    return runs;
}

std::uint64_t other_colours(const Picture& a, const Picture& b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) count += a.pixels()[i] == b.pixels()[i] ? 0 : 1;
    return count;
}

struct NamedShading {
    const char* name;
    ShadingTime time;
    Optimizations optimizations;
};

constexpr std::array named_shadings{
    NamedShading{"late z", ShadingTime::before_the_test, plain},
    NamedShading{"early z", ShadingTime::after_the_test, plain},
    NamedShading{"early z, front to back",
                 ShadingTime::after_the_test,
                 {.hierarchical_z = HierarchicalZ::none, .order = DrawOrder::chunks_front_to_back}},
    NamedShading{"early z, hierarchical z, front to back",
                 ShadingTime::after_the_test,
                 {.order = DrawOrder::chunks_front_to_back}},
};

std::vector<ShadingRun> shading_runs(const Scene& scene, const View& view, int repeats) {
    const Light light;
    const std::vector<Chunk> chunks = chunks_of(scene);
    Renderer renderer;
    const Frame frame = renderer.render(scene, view);
    const Picture deferred = shade(scene, view, frame, light);
    std::vector<ShadingRun> runs(named_shadings.size() + 1);
    std::deque<Pipeline> pipelines;
    std::vector<std::function<void()>> works;
    for (std::size_t i = 0; i < named_shadings.size(); ++i) {
        const NamedShading& named = named_shadings[i];
        Pipeline& pipeline = pipelines.emplace_back(correct_rules, widest_of(kernels), named.optimizations);
        runs[i].name = named.name;
        works.emplace_back([&, i] {
            const ShadedFrame shaded = pipeline.render_shaded(scene, view, light, named.time, chunks);
            runs[i].shaded = shaded.shaded;
            runs[i].other_colours = other_colours(shaded.picture, deferred);
        });
    }
    runs.back().name = "deferred: shaded when all is drawn";
    for (const PrimitiveId id : frame.primitive.pixels())
        runs.back().shaded += id != PrimitiveId::none ? 1 : 0;
    works.emplace_back([&] { shade(scene, view, renderer.render(scene, view), light); });
    const std::vector<Timing> timings = timed_in_turn(repeats, works);
    for (std::size_t i = 0; i < runs.size(); ++i) runs[i].timing = timings[i];
    return runs;
}

}  // namespace

std::uint64_t open_edge_count(const Scene& scene) {
    std::map<Edge, std::int64_t> open;
    for (const glm::uvec3& t : scene.triangles)
        for (int k = 0; k < 3; ++k) {
            const Position from = place_of(scene.vertices.position_world[t[k]]);
            const Position to = place_of(scene.vertices.position_world[t[(k + 1) % 3]]);
            if (from == to) continue;
            if (from < to)
                ++open[{from, to}];
            else
                --open[{to, from}];
        }
    std::uint64_t count = 0;
    for (const auto& [edge, balance] : open) count += std::uint64_t(balance < 0 ? -balance : balance);
    return count;
}

OptimizationStudy study_optimizations(const Scene& scene, const View& view, int repeats) {
    OptimizationStudy study{scene.name, view.name, open_edge_count(scene), {}, {}};
    Pipeline plain_pipeline(correct_rules, widest_of(kernels), plain);
    plain_pipeline.render(scene, view);
    const Frame plain_frame = plain_pipeline.take_frame();
    Gate gate(scene, view, plain_frame);
    const std::vector<Chunk> chunks = chunks_of(scene);
    study.runs = optimization_runs(scene, view, repeats);
    for (OptimizationRun& run : study.runs) {
        Pipeline pipeline(correct_rules, widest_of(kernels), run.optimizations);
        run.same = gate.ask(pipeline.render(scene, view, chunks));
    }
    study.shading = shading_runs(scene, view, repeats);
    return study;
}

}  // namespace zproof::study::cost
