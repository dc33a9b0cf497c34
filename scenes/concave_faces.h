/// Faces that their fan would not cover: triangles of it overlap, or reach beyond the outline.
#pragma once

#include <span>

#include "scenes/polygon_mesh.h"

namespace zproof {

/// Makes the triangles of such faces anew, as many, by cutting ears off (Meisters, American Mathematical
/// Monthly 82, 1975): again and again, from the face's first corner on, the first corner whose triangle with
/// its two neighbours lies inside the face. Signs are exact, of the face as seen along the axis that it faces
/// most. Each run is a face, so far its fan. A face whose outline crosses itself stays a fan, with a note,
/// and so do those beyond limits::ear_tests.
void cut_concave_faces(std::span<const TriangleRun> faces, Scene& scene);

}  // namespace zproof
