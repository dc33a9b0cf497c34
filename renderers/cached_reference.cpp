#include "renderers/cached_reference.h"

#include <memory>
#include <optional>
#include <utility>

#include "oracle/embree.h"
#include "program/version.h"

namespace zproof {
namespace {

/// Embree, and the frames that it gave in other runs.
class KeepingEmbree {
  public:
    KeepingEmbree(const Scene& scene, std::string scene_sha256, oracle::ReferenceCache& cache)
        : scene_(scene),
          scene_sha256_(std::move(scene_sha256)),
          tracer_(oracle::embree_version() + " " + version_number() + " " + commit()),
          cache_(cache) {}

    Frame frame(const View& view) {
        const std::string key = oracle::reference_key(scene_sha256_, view, tracer_);
        if (auto kept = cache_.find(key, {view.width, view.height})) return std::move(*kept);
        if (!embree_) embree_.emplace(scene_);
        Frame traced = embree_->trace(view);
        cache_.keep(key, traced);
        return traced;
    }

  private:
    const Scene& scene_;
    std::string scene_sha256_, tracer_;
    oracle::ReferenceCache& cache_;
    std::optional<oracle::Embree> embree_;
};

bool is_embree(const RendererChoice& choice) {
    const auto* built_in = std::get_if<BuiltIn>(&choice.who);
    return built_in != nullptr && built_in->name == "embree" && choice.ids == RendererChoice{}.ids;
}

}  // namespace

Renderer open_with_cache(const RendererChoice& choice, const Scene& scene, const std::string& scene_sha256,
                         oracle::ReferenceCache& cache) {
    if (!is_embree(choice)) return open(choice, scene);
    const auto embree = std::make_shared<KeepingEmbree>(scene, scene_sha256, cache);
    return {.name = name_of(choice),
            .precision = declared_precision(choice),
            .projections = declared_projections(choice),
            .render = [embree](const View& view) { return embree->frame(view); },
            .paint = {},
            .begin_sample = {},
            .sample_price_s = {},
            .channels = {},
            .labels = {}};
}

}  // namespace zproof
