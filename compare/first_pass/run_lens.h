/// What triangles' corners say of their depths with no laws between: of a strip's runs, where each shows
/// another triangle, and of a tile's triangles.
#pragma once

#include <optional>
#include <span>

#include "compare/strips/kernel.h"
#include "compare/witness.h"

namespace zproof {

/// Of a perspective whose renderers both have terms that hold for every triangle. It looks into the scene.
std::optional<strips::RunLens> run_lens_of(const Scene& scene, const Witness& candidate,
                                           const Witness& reference);

/// Asks for the memory in which the triangles of a strip are.
void fetch_triangles(const Scene& scene, const Strip& strip);
/// The runs of a strip whose ids were compared; asks for the memory in which their corners are. The scene has
/// a triangle.
void set_runs(const Scene& scene, const Strip& strip, strips::Runs& runs);

/// Triangles of the scene, and a part of the image.
struct TrianglesInTile {
    std::span<const PrimitiveId> triangles;
    PixelBox tile;
};
/// Writes the tolerance of each there.
void set_tolerances(const strips::Kernel& kernel, const strips::RunLens& lens, const Scene& scene,
                    const TrianglesInTile& of, std::span<DepthTolerance> tolerances);

}  // namespace zproof
