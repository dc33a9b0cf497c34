/// Frames whose ids are coarser than triangles: a label stands for many triangles, or there are no ids at
/// all (docs/labels.md). The judge takes triangles, so each label is turned into one of its triangles first.
#pragma once

#include "compare/rendered_frame.h"
#include "scenes/triangle_labels.h"

namespace zproof {

/// A triangle that no scene has: it stands for a label that no triangle has.
inline constexpr PrimitiveId no_such_triangle{0xFFFF'FFFE};

/// What a frame says that names no triangles.
struct SaidLabels {
    const TriangleLabels& labels;
    const Plane<PrimitiveId>& ids;  ///< as the frame gives them; empty where it has none
};

/// A triangle's label; none where it is none of the scene's.
PrimitiveId label_of(const TriangleLabels& labels, PrimitiveId triangle);

/// Do both triangles have one label? Not where one is none of the scene's.
bool have_one_label(const TriangleLabels& labels, PrimitiveId one, PrimitiveId other);

/// A frame of triangles as a frame of labels.
Frame with_labels(Frame of_triangles, const TriangleLabels& labels);

/// Names a triangle of each pixel's label that a faultless renderer may show there at that depth, if there is
/// one: the reference's own where it proves that, or else the one that is admissible for the strongest
/// reason. Where there is none, a triangle of the label that lets the judge say what is wrong. Runs on the
/// threads of the surrounding tbb::task_arena; the result does not depend on their number. All frames have
/// the view's size.
Frame with_triangles(const Scene& scene, const View& view, const RenderedFrame& of_labels,
                     const TriangleLabels& labels, const RenderedFrame& reference);

/// What the frame itself says at a pixel, after a finding about its triangle: "; the frame says material 3
/// (Wood)". Empty where it gives triangles.
std::string label_sentence(const TriangleLabels& labels, PrimitiveId said);

/// The frame of these ids, each with the depth of the named triangle's plane at the pixel's centre, rounded
/// to float32; 0 where there is none. Background has +infinity; an id that no triangle has, 0. Runs on the
/// threads of the surrounding tbb::task_arena; the result does not depend on their number. Planes have the
/// view's size.
Frame with_own_depths(const Scene& scene, const View& view, const Plane<PrimitiveId>& ids,
                      const Precision& precision);
/// The promise of a renderer that shows such depths in steps so large that they say nothing: none is wrong.
/// What decides which triangle is shown keeps its bounds.
Precision with_any_depth(Precision precision, const View& view, const Frame& own_depths);

}  // namespace zproof
