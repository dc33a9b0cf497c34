/// What the viewer shows of one view, and the file that holds it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/explanation/explain.h"
#include "compare/explanation/illustration.h"
#include "compare/verdict.h"
#include "frame/frame.h"
#include "frame/picture.h"
#include "reports/planes/container.h"

namespace zproof::planes {

/// Triangles that came from one primitive of one mesh at one node.
struct TriangleRange {
    std::uint32_t first = 0, count = 0;
    std::string node, mesh;
    int primitive = 0;
};

/// One pixel's story with a drawing.
struct Story {
    PixelExplanation story;
    std::string text;  ///< what `zproof explain` prints
    std::vector<NearbyImage> images;
};

/// A renderer's answers, and its colours where it painted.
struct Renderer {
    std::string name;
    const Frame& frame;
    Picture colours;  ///< 0 x 0: none
};

/// What holds for the whole view.
struct ViewFacts {
    std::string scene, view;
    std::string explain_before, explain_after;  ///< "zproof explain room ", " --view corner": around "X Y"
    double least_inverse_depth = 0,
           greatest_inverse_depth = 0;  ///< at far and near (compare/bounds/triangle_image.h)
    bool perspective = true;            ///< or is inverse depth the negative depth?
};

struct ViewPlanes {
    ViewFacts facts;
    Renderer candidate, reference;
    std::vector<Renderer> oracles;
    const Verdict& verdict;
    Plane<float> candidate_error, reference_error;  ///< error / bound (ErrorMaps)
    std::vector<TriangleRange> ranges;
    std::vector<Story> stories;
};

/// The most findings that are listed one by one, defects first; the class map always has all.
inline constexpr std::size_t most_findings = 20'000;
inline constexpr std::size_t most_in_summary = 100;  ///< of PlanesDetail::differences

/// How much of a view is kept.
enum class PlanesDetail {
    differences,  ///< classes, findings, stories, names: a few kilobytes where little differs
    all,
};

/// Blocks in order of need: classes, findings, stories, names; ids; errors; depths; oracles; colours. Every
/// plane's block has the CRC-32 of what it decodes to. On the threads of the surrounding tbb::task_arena.
Container container_of(const ViewPlanes& planes, PlanesDetail detail = PlanesDetail::all);

/// container_of() as folder/planes.zvp. Throws FrameError where it cannot be written.
void write_view_planes(const std::filesystem::path& folder, const ViewPlanes& planes,
                       PlanesDetail detail = PlanesDetail::all);

}  // namespace zproof::planes
