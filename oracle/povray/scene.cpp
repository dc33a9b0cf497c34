#include "oracle/povray/scene.h"

#include "frame/number_text.h"
#include "oracle/povray/camera.h"
#include "oracle/povray/geometry.h"
#include "oracle/povray/text.h"

namespace zproof::oracle {
namespace {

std::string depth_expression(const Camera& camera) {
    const glm::dvec3 ahead = -camera.back;
    return shortest(ahead.x) + "*x+" + shortest(ahead.y) + "*y+" + shortest(ahead.z) + "*z";
}

void append_triangle(std::string& text, const PovrayTriangle& triangle, const PovrayCode& code) {
    const auto [red, green] = code.colour_of(triangle.primitive);
    text += "triangle{" + vector_text(triangle.corner[0]) + "," + vector_text(triangle.corner[1]) + "," +
            vector_text(triangle.corner[2]) + "pigment{average pigment_map{[2 rgb<" + shortest(2 * red) +
            "," + shortest(2 * green) + ",0>][1 Lower][1 Upper]}}}\n";
}

/// The box is there for its size alone: it is in no picture (no_image), yet in the merge's own box, which
/// POV-Ray would otherwise draw too tight for its own arithmetic. (In a union, no_image does not count.)
void append_cluster(std::string& text, const PovrayCluster& cluster, const PovrayCode& code,
                    const std::string& clip) {
    text += "merge{box{" + vector_text(cluster.lowest) + "," + vector_text(cluster.highest) + "no_image}\n";
    for (const PovrayTriangle& triangle : cluster.triangles) append_triangle(text, triangle, code);
    if (cluster.cut == Cut::by_near_or_far) text += clip;
    text += "}\n";
}

}  // namespace

PovrayScene povray_scene(const Scene& scene, const View& view) {
    const Camera& camera = view.camera;
    const PovrayGeometry geometry = povray_geometry(scene, view);
    const PovrayUnits& units = geometry.units;
    const bool perspective = camera.projection == Projection::perspective;
    PovrayCode code(scene.triangles.size(), perspective ? DepthSteps::logarithmic : DepthSteps::linear,
                    units.low, units.high);
    std::string text =
        "#version 3.7;\n"
        "global_settings{assumed_gamma 1}\n"
        "#default{finish{ambient 0 diffuse 0 emission 1}}\n"
        "background{rgb 0}\n" +
        povray_camera_text(view, units) + code.depth_pigments(depth_expression(camera));
    const std::string clip = povray_clip_text(camera, units);
    for (const PovrayCluster& cluster : geometry.clusters) append_cluster(text, cluster, code, clip);
    return {std::move(text), code, units.scale};
}

}  // namespace zproof::oracle
