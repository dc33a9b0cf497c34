/// The texture filters of a device, held to their definition by zproof-filters (docs/conformance.md).
#pragma once

#include <vector>

#include "program/common_arguments.h"
#include "renderers/choice.h"
#include "reports/conformance_report.h"

namespace zproof {

/// One for each filter of the renderer that has a definition; none where zproof asks no textures of it.
std::vector<TexturePromise> texture_promises(const RendererChoice& renderer, const CommonArguments& common);

}  // namespace zproof
