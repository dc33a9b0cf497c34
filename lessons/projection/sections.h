/// The projection study as sections of a document.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/projection/accuracy.h"
#include "lessons/projection/edge_distance.h"
#include "lessons/projection/wireframe.h"
#include "reports/pages/document.h"

namespace zproof {

/// A picture that somebody made of the view.
struct ProjectedPicture {
    std::string renderer;  ///< "zproof"
    Plane<Rgb8> pixels;
};

/// All that was found out about one view.
struct ProjectedView {
    std::string title, stem;  ///< "room / door", "room-door"
    Resolution size;
    study::projection::ViewAccuracy accuracy;
    study::projection::Wireframe wireframe;  ///< told apart
    std::vector<study::projection::EdgeAgreement> agreements;
    std::vector<ProjectedPicture> pictures;  ///< each gets the wireframe laid over it
    Plane<Rgb8> ids;                         ///< the rasterizer's, in colours
    std::vector<std::string> absences;       ///< "POV-Ray was not asked: ...": sentences
};

/// Which routes and visibility tests of the lessons are right, and the worked example.
document::Section lesson_section();

/// Vertices: errors of every route, where pixels are lost.
document::Section vertex_section(const ProjectedView& view);

/// The section about lessons/projection/border_lattice.h.
document::Section border_section(const study::projection::ViewAccuracy& accuracy);

/// Wireframe beside and over the pictures, and the distance between them.
document::Section wireframe_section(const ProjectedView& view);

/// What the whole study says, in a few sentences.
std::vector<std::string> projection_introduction(const std::vector<ProjectedView>& views);

}  // namespace zproof
