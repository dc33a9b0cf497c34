/// A candidate's frame as the judge takes it: with triangles in the places of labels (docs/labels.md).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "compare/labels/labelled_frame.h"
#include "renderers/registry.h"
#include "scenes/triangle_labels.h"

namespace zproof {

struct CandidateFrame {
    Frame frame;                                   ///< of triangles
    std::shared_ptr<const TriangleLabels> labels;  ///< what its own ids stand for; nothing: triangles
    Plane<PrimitiveId> own_ids;                    ///< where they stand for labels

    /// What it says, where that is no triangle.
    std::optional<SaidLabels> said() const;
    /// What it says itself at a pixel, to follow a finding; empty where that is a triangle or background.
    std::string label_sentence(int x, int y) const;
};

/// Takes the frame that the renderer gave; without its attributes, where its ids stand for labels.
CandidateFrame candidate_frame(const Scene& scene, const View& view, const Renderer& renderer, Frame given,
                               const RenderedFrame& reference);

}  // namespace zproof
