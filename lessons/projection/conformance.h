/// Is a way of projecting the projection? Routes and visibility tests are tried on probe cameras in exact
/// arithmetic and held against the view ray as scenes/camera.h defines it, space by space.
#pragma once

#include <string>
#include <vector>

#include "lessons/projection/routes.h"

namespace zproof::study::projection {

/// A camera whose axes are orthonormal without rounding.
struct ProbeCamera {
    std::string name;
    NumericCamera<Rational> camera;
};

/// The lesson's own default first (canvas [-1, 1], near 1), under which some slips stay unseen; then nearer
/// and farther planes, narrow and off-axis canvases, orthographic and oblique ones.
std::vector<ProbeCamera> probe_cameras();

/// World-space points before the eye of a probe camera, the same ones every time.
std::vector<Vector3<Rational>> probe_points(const NumericCamera<Rational>& camera);

/// Does a point on its way stand where the view ray says? Asked of each space in its own terms; nothing
/// of the stages is used. The camera must be one of probe_cameras().
bool is_on_view_ray(Space space, const NumericCamera<Rational>& camera, const Vector3<Rational>& p_world,
                    const Travel<Rational>& travel);

/// The raster position whose view ray holds the point.
Point2<Rational> exact_raster(const NumericCamera<Rational>& camera, const Vector3<Rational>& p_world);

struct RouteFinding {
    RouteCard card;
    int cameras = 0, cameras_kept = 0;  ///< probe cameras that it was tried on; on which it is the projection
    std::string first_wrong_stage;      ///< empty where it is the projection on all of them
    std::string operation, space;       ///< that stage's last operation, and the space it should arrive in
    std::string camera;                 ///< the first camera on which it goes wrong
    double worst_px = 0;  ///< distance from the exact raster position over all probes, in x or y

    bool is_projection() const { return first_wrong_stage.empty(); }
};

std::vector<RouteFinding> route_findings();

/// A rule that says whether a point of the image plane lies on a canvas of width W and height H about the
/// axis.
struct VisibilityTest {
    std::string name, formula, source;
    std::function<bool(const Point2<Rational>& p_screen, const Rational& width, const Rational& height)>
        calls_visible;
};

/// The right one first, then those of the lesson's text and listing.
std::vector<VisibilityTest> visibility_tests();

struct VisibilityFinding {
    std::string name, formula, source;
    int points = 0, shown_wrongly = 0, hidden_wrongly = 0;
    std::string example;  ///< "(3/2, 0) on a canvas of 2 x 2 is called visible"; empty where there is none
};

/// The findings on a lattice over three times the canvas, its border included.
std::vector<VisibilityFinding> visibility_findings();

}  // namespace zproof::study::projection
