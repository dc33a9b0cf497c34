#include "lessons/shading/tessellation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "rasterizer/rasterizer.h"
#include "rasterizer/surface.h"
#include "scenes/suite/views.h"

namespace zproof::study::shading {
namespace {

constexpr double no_light = std::numeric_limits<double>::quiet_NaN();

/// Grows an icosahedron; an edge's middle is one vertex for both its triangles.
class Icosphere {
  public:
    Icosphere() {
        const double t = (1 + std::sqrt(5.0)) / 2;
        for (const double a : {-1.0, 1.0})
            for (const double b : {-t, t}) {
                add({0, a, b});
                add({a, b, 0});
                add({b, 0, a});
            }
        add_faces();
    }

    void refine() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, 0u);
            if (is_new) found->second = add(points_[a] + points_[b]);
            return found->second;
        };
        Bulk<glm::uvec3> finer;
        for (const glm::uvec3& f : faces_) {
            const std::uint32_t ab = middle(f.x, f.y), bc = middle(f.y, f.z), ca = middle(f.z, f.x);
            for (const glm::uvec3& part : {glm::uvec3{f.x, ab, ca}, glm::uvec3{ab, f.y, bc},
                                           glm::uvec3{ca, bc, f.z}, glm::uvec3{ab, bc, ca}})
                finer.push_back(part);
        }
        faces_ = std::move(finer);
    }

    Scene scene() const {
        Scene scene;
        scene.name = "sphere";
        for (const glm::dvec3& p : points_) {
            scene.vertices.position_world.push_back(glm::vec3(p));
            scene.vertices.normal_world.push_back(glm::vec3(p));
        }
        scene.triangles = faces_;
        scene.materials.push_back({});
        Part part;
        part.node = "sphere";
        part.triangle_count = std::uint32_t(faces_.size());
        scene.parts.push_back(part);
        return scene;
    }

  private:
    std::uint32_t add(const glm::dvec3& p) {
        points_.push_back(glm::normalize(p));
        return std::uint32_t(points_.size() - 1);
    }

    /// Every three corners that are one edge length apart, turned outwards.
    void add_faces() {
        const double edge = 1.06;  // 1.0515 on the unit sphere; the next distance is 1.70
        const auto near = [&](std::uint32_t a, std::uint32_t b) {
            return glm::length(points_[a] - points_[b]) < edge;
        };
        for (std::uint32_t a = 0; a < 12; ++a)
            for (std::uint32_t b = a + 1; b < 12; ++b)
                for (std::uint32_t c = b + 1; c < 12; ++c) {
                    if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
                    const glm::dvec3 n = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
                    faces_.push_back(glm::dot(n, points_[a]) > 0 ? glm::uvec3{a, b, c} : glm::uvec3{a, c, b});
                }
    }

    std::vector<glm::dvec3> points_;
    Bulk<glm::uvec3> faces_;
};

/// The point where a ray from the eye first meets the unit sphere.
std::optional<glm::dvec3> met(const View& view, int x, int y) {
    const rasterizer::PixelRay line = rasterizer::pixel_ray(view, x + 0.5, y + 0.5);
    const glm::dvec3 eye{view.camera.eye_world};
    const double a = glm::dot(line.to, line.to), b = glm::dot(eye, line.to), c = glm::dot(eye, eye) - 1;
    const double root = b * b - a * c;
    if (root < 0) return std::nullopt;
    return eye + (-b - std::sqrt(root)) / a * line.to;
}

double on_sphere(const View& view, const Lighting& lighting, const glm::dvec3& p) {
    return intensity({p, p, glm::normalize(glm::dvec3(view.camera.eye_world) - p)}, lighting.light_source,
                     lighting.finish);
}

double peak_of(const Plane<double>& picture) {
    double peak = 0;
    for (const double value : picture.pixels())
        if (value > peak) peak = value;
    return peak;
}

double percentile99(std::vector<double> values) {
    if (values.empty()) return no_light;
    std::ranges::sort(values);
    return values[std::min(values.size() - 1, std::size_t(0.99 * double(values.size())))];
}

/// Does the sphere turn by no more than 45 degrees from the eye there?
bool is_faced(const View& view, int x, int y) {
    const auto p = met(view, x, y);
    return p && glm::dot(*p, glm::normalize(glm::dvec3(view.camera.eye_world) - *p)) > std::sqrt(0.5);
}

void add_bends(LevelScore& score, const View& view, const Frame& frame, const Plane<float>& bend) {
    std::vector<double> at_edges, inside;
    for (int y = 1; y + 1 < frame.size().height; ++y)
        for (int x = 1; x + 1 < frame.size().width; ++x) {
            if (std::isnan(bend.at(x, y)) || !is_faced(view, x, y)) continue;
            const PrimitiveId id = frame.primitive.at(x, y);
            const bool one = frame.primitive.at(x - 1, y) == id && frame.primitive.at(x + 1, y) == id &&
                             frame.primitive.at(x, y - 1) == id && frame.primitive.at(x, y + 1) == id;
            (one ? inside : at_edges).push_back(double(bend.at(x, y)));
        }
    score.bend_at_edges = percentile99(std::move(at_edges));
    score.bend_inside = percentile99(std::move(inside));
}

Plane<double> intensity_difference(const Plane<double>& a, const Plane<double>& b) {
    Plane<double> difference(a.size());
    for (std::size_t i = 0; i < a.pixels().size(); ++i)
        difference.pixels()[i] = std::abs(a.pixels()[i] - b.pixels()[i]);
    return difference;
}

void add_errors(LevelScore& score, const Plane<double>& difference) {
    double squares = 0;
    std::size_t count = 0;
    for (const double d : difference.pixels()) {
        if (std::isnan(d)) continue;
        squares += d * d;
        score.largest = std::max(score.largest, d);
        ++count;
    }
    score.rmse = count == 0 ? no_light : std::sqrt(squares / double(count));
}

double median_edge_px(const Scene& scene, const View& view) {
    const Camera& c = view.camera;
    const double px = view.width / (c.window.right - c.window.left);
    std::vector<double> lengths;
    for (const glm::uvec3& t : scene.triangles) {
        const glm::dvec3 a{scene.vertices.position_world[t.x]}, b{scene.vertices.position_world[t.y]};
        lengths.push_back(glm::length(a - b) * px / (double(c.eye_world.z) - 1));
    }
    std::ranges::nth_element(lengths, lengths.begin() + std::ptrdiff_t(lengths.size() / 2));
    return lengths[lengths.size() / 2];
}

/// The brightest place of the sphere, from the picture of it: to the half of a pixel.
glm::dvec3 centre_of_highlight(const View& view, const Plane<double>& round) {
    double peak = 0;
    glm::dvec3 centre{0, 0, 1};
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            if (round.at(x, y) > peak) {
                peak = round.at(x, y);
                centre = *met(view, x, y);
            }
    return centre;
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// Mirroring doubles the angle by which a normal is off, halving the way to the eye does not.
double half_width_degrees(const Finish& finish) {
    const double angle = std::acos(std::exp2(-1 / finish.exponent)) * 180 / std::numbers::pi;
    return finish.highlight == Highlight::phong ? angle / 2 : angle;
}

MissedHighlight missed_at(int level, const Scene& scene, const View& view, const Lighting& lighting,
                          const Frame& frame) {
    const Plane<double> round = round_picture(view, lighting);
    const glm::dvec3 centre = centre_of_highlight(view, round);
    MissedHighlight missed{.level = level, .nearest_degrees = 180};
    missed.half_width_degrees = half_width_degrees(lighting.finish);
    missed.sphere_peak = peak_of(round);
    for (const PrimitiveId id : frame.primitive.pixels()) {
        if (id == PrimitiveId::none) continue;
        const glm::uvec3 t = scene.triangles[std::size_t(id)];
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p = glm::normalize(glm::dvec3(scene.vertices.position_world[t[k]]));
            missed.nearest_degrees = std::min(missed.nearest_degrees, degrees_between(p, centre));
            missed.predicted_peak = std::max(missed.predicted_peak, on_sphere(view, lighting, p));
        }
    }
    return missed;
}

}  // namespace

Loaded sphere(int level, int side_px) {
    Icosphere mesh;
    for (int i = 0; i < level; ++i) mesh.refine();
    View view = suite::perspective_view("ahead", {side_px, side_px},
                                        {.eye_world = {0, 0, 4}, .target_world = {0, 0, 0}},
                                        {.half_height = 0.29, .near_depth = 1, .far_depth = 10});
    return {mesh.scene(), {view}};
}

Plane<double> round_picture(const View& view, const Lighting& lighting) {
    Plane<double> picture({view.width, view.height}, no_light);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            if (const auto p = met(view, x, y)) picture.at(x, y) = on_sphere(view, lighting, *p);
    return picture;
}

Plane<float> bends(const Plane<double>& intensity) {
    const Resolution size = intensity.size();
    Plane<float> bend(size, std::numeric_limits<float>::quiet_NaN());
    const auto second = [](double a, double b, double c) { return std::abs(a - 2 * b + c); };
    for (int y = 1; y + 1 < size.height; ++y)
        for (int x = 1; x + 1 < size.width; ++x) {
            const double here = intensity.at(x, y);
            const double across = second(intensity.at(x - 1, y), here, intensity.at(x + 1, y));
            const double down = second(intensity.at(x, y - 1), here, intensity.at(x, y + 1));
            if (!std::isnan(across + down)) bend.at(x, y) = float(std::max(across, down));
        }
    return bend;
}

TessellationStudy study_tessellation(const Lighting& lighting, int most_levels, int side_px) {
    TessellationStudy study;
    for (int level = 0; level <= most_levels; ++level) {
        const Loaded loaded = sphere(level, side_px);
        const View& view = loaded.views.front();
        const Frame frame = rasterizer::render(loaded.scene, view);
        const Plane<double> round = round_picture(view, lighting);
        study.missed.push_back(missed_at(level, loaded.scene, view, lighting, frame));
        for (const Method method : all_methods) {
            LevelScore score{.level = level, .triangles = loaded.scene.triangles.size(), .method = method};
            score.edge_px = median_edge_px(loaded.scene, view);
            LevelPicture shown{
                level, method, picture(loaded.scene, view, frame, lighting, {.method = method}), {}, {}};
            shown.difference = intensity_difference(shown.intensity, round);
            shown.bend = bends(shown.intensity);
            add_errors(score, shown.difference);
            add_bends(score, view, frame, shown.bend);
            score.peak = peak_of(shown.intensity);
            score.peak_of_sphere = peak_of(round);
            if (method == Method::gouraud) study.missed.back().measured_peak = score.peak;
            study.scores.push_back(score);
            study.pictures.push_back(std::move(shown));
        }
    }
    return study;
}

}  // namespace zproof::study::shading
