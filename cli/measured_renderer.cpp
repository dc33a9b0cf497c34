#include "cli/measured_renderer.h"

#include "cli/renderers/registry.h"

namespace zproof {

measure::Renderer measured_renderer(const RendererChoice& choice) {
    return {
        .name = name_of(choice),
        .render = [choice](const Scene& scene, const View& view) { return open(choice, scene).render(view); },
        .declared = declared_precision(choice)};
}

}  // namespace zproof
