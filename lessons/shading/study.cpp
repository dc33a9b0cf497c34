#include "lessons/shading/study.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "oracle/povray.h"
#include "rasterizer/rasterizer.h"
#include "scenes/light.h"

namespace zproof::study::shading {
namespace {

glm::dvec3 in_world(const Camera& c, const glm::dvec3& camera) {
    return camera.x * c.right + camera.y * c.up + camera.z * c.back;
}

double median_depth(const Frame& frame) {
    std::vector<float> depths;
    for (const float d : frame.camera_depth.pixels())
        if (std::isfinite(d)) depths.push_back(d);
    if (depths.empty()) return 1;
    std::ranges::nth_element(depths, depths.begin() + std::ptrdiff_t(depths.size() / 2));
    return double(depths[depths.size() / 2]);
}

LightSource point_light(const View& view, const Frame& frame) {
    const double reach = median_depth(frame) / 2;
    return {LightSource::Kind::point,
            glm::dvec3(view.camera.eye_world) + in_world(view.camera, glm::dvec3{reach, reach, 0})};
}

/// The pixels where both frames name the same triangle; elsewhere an edge decides, not shading.
Frame agreed(const Frame& ours, const Frame& traced) {
    Frame frame = ours;
    for (std::size_t i = 0; i < frame.primitive.pixels().size(); ++i)
        if (ours.primitive.pixels()[i] != traced.primitive.pixels()[i])
            frame.primitive.pixels()[i] = PrimitiveId::none;
    return frame;
}

struct Difference {
    double rmse = 0, largest = 0;
    Plane<double> map;
};

Difference difference_of(const Plane<double>& a, const Plane<double>& b) {
    Difference difference{0, 0, Plane<double>(a.size())};
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const double d = difference.map.pixels()[i] = std::abs(a.pixels()[i] - b.pixels()[i]);
        if (std::isnan(d)) continue;
        squares += d * d;
        difference.largest = std::max(difference.largest, d);
        ++count;
    }
    difference.rmse = count == 0 ? 0 : std::sqrt(squares / double(count));
    return difference;
}

/// Gouraud: between two corners whose depths have the ratio r, weights are off by at most
/// (sqrt r - 1) / (sqrt r + 1), and so is what is mixed, as a share of its range over the triangle.
double most_that_affine_costs(const Scene& scene, const View& view, const Frame& frame,
                              const Lighting& lighting) {
    double most = 0;
    std::vector<bool> seen(scene.triangles.size());
    for (const PrimitiveId id : frame.primitive.pixels()) {
        if (id == PrimitiveId::none || seen[std::size_t(id)]) continue;
        seen[std::size_t(id)] = true;
        const Facet facet = facet_of(scene, view, std::uint32_t(id));
        std::array<double, 3> depth{}, sent{};
        for (std::size_t k = 0; k < 3; ++k) {
            depth[k] = -glm::dot(view.camera.back, facet.p_world[k] - glm::dvec3(view.camera.eye_world));
            Weights corner{0, 0, 0};
            corner[k] = 1;
            sent[k] = shaded(facet, view, lighting, Method::gouraud, corner);
        }
        const auto [near, far] = std::ranges::minmax(depth);
        const auto [low, high] = std::ranges::minmax(sent);
        // A corner behind the eye: nothing is known but the range itself.
        const double share = near > 0 ? (std::sqrt(far / near) - 1) / (std::sqrt(far / near) + 1) : 1;
        most = std::max(most, share * (high - low));
    }
    return most;
}

/// One view under one light.
class ShadingScorer {
  public:
    ShadingScorer(const Scene& scene, const View& view, const Frame& frame, const Lighting& lighting)
        : scene_(scene),
          view_(view),
          frame_(frame),
          lighting_(lighting),
          phong_(at({.method = Method::phong, .rule = traced_weights})) {}

    SceneScore score(Method method, Mixing mixing) const {
        SceneScore score{.method = method,
                         .mixing = mixing,
                         .highlight = lighting_.finish.highlight,
                         .light_source = lighting_.light_source.kind};
        const Plane<double> ours = at({method, mixing, rasterized_weights});
        const Difference to_traced = difference_of(ours, at({.method = method, .rule = traced_weights}));
        const Difference to_phong = difference_of(ours, phong_);
        score.rmse_to_traced = to_traced.rmse;
        score.largest_to_traced = to_traced.largest;
        score.rmse_to_phong = to_phong.rmse;
        score.largest_to_phong = to_phong.largest;
        if (method == Method::gouraud && mixing == Mixing::affine)
            score.predicted_largest = most_that_affine_costs(scene_, view_, frame_, lighting_);
        return score;
    }

    ScenePicture shown(Method method, Mixing mixing) const {
        Plane<double> ours = at({method, mixing, rasterized_weights});
        Difference difference = difference_of(ours, phong_);
        return {std::string{name_of(method)} + (mixing == Mixing::affine ? ", affine" : ""), std::move(ours),
                std::move(difference.map)};
    }

  private:
    Plane<double> at(const Technique& technique) const {
        return picture(scene_, view_, frame_, lighting_, technique);
    }

    const Scene& scene_;
    const View& view_;
    const Frame& frame_;
    Lighting lighting_;
    Plane<double> phong_;
};

/// Faceted shading mixes nothing.
template <class Visit>
void for_each_technique(Visit visit) {
    for (const Method method : all_methods)
        for (const Mixing mixing : {Mixing::perspective, Mixing::affine})
            if (method != Method::faceted || mixing == Mixing::perspective) visit(method, mixing);
}

/// White, so that light alone is seen.
Scene without_materials(const Scene& scene) {
    Scene white = scene;
    for (Material& material : white.materials) material = {};
    white.vertices.color.clear();
    return white;
}

/// Does the mixed normal point away from the eye, though the face does not?
bool is_turned(const Facet& facet, const View& view, const Weights& w) {
    const glm::dvec3 normal = w[0] * facet.normal[0] + w[1] * facet.normal[1] + w[2] * facet.normal[2];
    const glm::dvec3 place = w[0] * facet.p_world[0] + w[1] * facet.p_world[1] + w[2] * facet.p_world[2];
    return glm::dot(normal, glm::dvec3(view.camera.eye_world) - place) <= 0;
}

PovrayScore held_against(const Picture& theirs, const Scene& scene, const View& view, const Frame& frame) {
    const Lighting lighting = lighting_of(view, Highlight::phong);
    const Plane<double> ours = picture(scene, view, frame, lighting, {});
    PovrayScore score;
    std::vector<double> differences;
    double squares = 0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const Facet facet = facet_of(scene, view, std::uint32_t(id));
            if (is_turned(facet, view, rasterized_weights(view, facet, x, y))) {
                ++score.turned;
                continue;
            }
            const double d = std::abs(std::min(1.0, ours.at(x, y)) - double(theirs.at(x, y).g));
            differences.push_back(d);
            squares += d * d;
        }
    if (differences.empty()) return score;
    std::ranges::sort(differences);
    score.pixels = differences.size();
    score.rmse = std::sqrt(squares / double(score.pixels));
    score.p99 = differences[std::size_t(0.99 * double(score.pixels - 1))];
    score.largest = differences.back();
    return score;
}

PovrayScore refused(const std::string& why) {
    PovrayScore score;
    score.not_asked = why;
    return score;
}

PovrayScore asked_of_povray(const Scene& scene, const View& view, const Frame& frame) {
    if (view.camera.projection == Projection::parallel) return refused("a parallel projection");
    if (!oracle::povray_version()) return refused("POV-Ray is not installed");
    const Finish finish = lighting_of(view, Highlight::phong).finish;
    Light light;
    light.ambient = finish.ambient;
    light.diffuse = finish.diffuse;
    const Scene white = without_materials(scene);
    try {
        const Picture theirs = oracle::PovRay(white).picture(view, light, {finish.specular, finish.exponent});
        return held_against(theirs, scene, view, frame);
    } catch (const OracleError& e) {
        return refused(e.what());
    }
}

}  // namespace

Lighting lighting_of(const View& view, Highlight highlight) {
    Lighting lighting{{LightSource::Kind::directional, in_world(view.camera, Light{}.toward_camera)}, {}};
    lighting.finish.highlight = highlight;
    return lighting;
}

int units_of_shading() { return 4; }

Scene with_normals(const Scene& scene) {
    Scene smooth = scene;
    if (!scene.vertices.normal_world.empty()) return smooth;
    const auto& p = scene.vertices.position_world;
    std::vector<glm::dvec3> sum(p.size(), glm::dvec3(0));
    for (const glm::uvec3& t : scene.triangles) {
        const glm::dvec3 a{p[t.x]}, b{p[t.y]}, c{p[t.z]};
        for (int k = 0; k < 3; ++k) sum[t[k]] += glm::cross(b - a, c - a);
    }
    for (const glm::dvec3& n : sum) {
        const double length = glm::length(n);
        smooth.vertices.normal_world.push_back(length > 0 ? glm::vec3(n / length) : glm::vec3(0));
    }
    return smooth;
}

ShadingStudy study_shading(const Scene& given, const View& view, const Announce& announce) {
    announce("frames");
    const Scene scene = with_normals(given);
    const Frame ours = rasterizer::render(scene, view), traced = oracle::Embree(scene).trace(view);
    const Frame frame = agreed(ours, traced);
    ShadingStudy study;
    study.scene = scene.name;
    study.view = view.name;
    for (std::size_t i = 0; i < frame.primitive.pixels().size(); ++i) {
        study.pixels += frame.primitive.pixels()[i] != PrimitiveId::none ? 1 : 0;
        study.other_ids += ours.primitive.pixels()[i] != traced.primitive.pixels()[i] ? 1 : 0;
    }
    announce("methods");
    for (const Highlight highlight : {Highlight::phong, Highlight::blinn_phong})
        for (const LightSource& light_source :
             {lighting_of(view, highlight).light_source, point_light(view, ours)}) {
            Lighting lighting = lighting_of(view, highlight);
            lighting.light_source = light_source;
            const ShadingScorer scorer{scene, view, frame, lighting};
            for_each_technique(
                [&](Method method, Mixing mixing) { study.scores.push_back(scorer.score(method, mixing)); });
        }
    announce("POV-Ray");
    study.povray = asked_of_povray(scene, view, frame);
    announce("pictures");
    const ShadingScorer scorer{scene, view, frame, lighting_of(view, Highlight::phong)};
    for_each_technique(
        [&](Method method, Mixing mixing) { study.pictures.push_back(scorer.shown(method, mixing)); });
    return study;
}

}  // namespace zproof::study::shading
