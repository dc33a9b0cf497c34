#include <algorithm>
#include <cmath>

#include "compare/admissible/neighbourhood.h"
#include "selftest/catalogue.h"

namespace zproof::selftest {
namespace {

/// A triangle where a view ray meets it. Greater inverse depth is nearer.
struct Hit {
    PrimitiveId id = PrimitiveId::none;
    double inverse_depth = 0;
    bool back = false;  ///< its corners run clockwise in the image
};

/// Does the hit take the place of the one that is held (none at first)? Asked in scene order.
using Choice = std::function<bool(const Hit& held, const Hit& hit)>;

struct Columns {
    int first, end;
};

/// The columns of a row on the inner side of all edges.
Columns inside(const TriangleImage<double>& image, int y, int width) {
    double first = 0, last = width - 1;
    for (const auto& edge : image.edge) {
        const double at_column_0 = edge.b * y + edge.c;
        if (edge.a > 0) first = std::max(first, std::ceil(-at_column_0 / edge.a));
        if (edge.a < 0) last = std::min(last, std::floor(at_column_0 / -edge.a));
        if (edge.a == 0 && at_column_0 < 0) return {0, 0};
    }
    return first <= last ? Columns{int(first), int(last) + 1} : Columns{0, 0};
}

bool faces_away(const View& view, const CornersWorld& p) {
    const glm::dvec3 v0{p[0]}, v1{p[1]}, v2{p[2]};
    return glm::dot(glm::cross(v1 - v0, v2 - v0), glm::dvec3(view.camera.eye_world) - v0) < 0;
}

/// Every triangle at every pixel, by the judge's own geometry: no clipping, no snapping, no tiles. For
/// perspective.
Plane<Hit> hits_by(const Fixture& fixture, const Choice& replaces) {
    const View& view = fixture.view;
    const double nearest = 1 / view.camera.near_depth, farthest = 1 / view.camera.far_depth;
    Plane<Hit> held({view.width, view.height});
    for (std::uint32_t t = 0; t < fixture.scene.triangles.size(); ++t) {
        const CornersWorld p_world = corners_of(fixture.scene, t);
        const auto image = image_of(ViewRay<double>(view, 0, 0), corners<double>(p_world));
        if (!image) continue;
        const bool back = faces_away(view, p_world);
        for (int y = 0; y < view.height; ++y) {
            const Columns columns = inside(*image, y, view.width);
            for (int x = columns.first; x < columns.end; ++x) {
                const Hit hit{PrimitiveId{t}, image->inverse_depth.at(x, y), back};
                if (hit.inverse_depth > nearest || hit.inverse_depth < farthest) continue;
                if (replaces(held.at(x, y), hit)) held.at(x, y) = hit;
            }
        }
    }
    return held;
}

std::function<Frame(const Fixture&)> drawn_by(const Choice& replaces) {
    return [=](const Fixture& fixture) {
        Frame frame({fixture.view.width, fixture.view.height});
        const Plane<Hit> hits = hits_by(fixture, replaces);
        for (std::size_t i = 0; i < hits.pixels().size(); ++i) {
            const Hit& hit = hits.pixels()[i];
            frame.primitive.pixels()[i] = hit.id;
            if (hit.id != PrimitiveId::none) frame.camera_depth.pixels()[i] = float(1 / hit.inverse_depth);
        }
        return frame;
    };
}

bool is_first_or(bool condition, const Hit& held) { return held.id == PrimitiveId::none || condition; }
bool nearer(const Hit& held, const Hit& hit) {
    return is_first_or(hit.inverse_depth > held.inverse_depth, held);
}

}  // namespace

std::vector<Fault> faults_of_visibility() {
    const Expected hidden{.classes = {PixelClass::hidden}, .count = {}};
    const Expected hole_and_hidden{.classes = {PixelClass::hole, PixelClass::hidden}, .count = {}};
    return {
        {"farthest_seen", "the depth test is turned round: the farthest surface is seen", hidden,
         drawn_by([](const Hit& held, const Hit& hit) {
             return is_first_or(hit.inverse_depth < held.inverse_depth, held);
         })},
        {"last_drawn_seen", "there is no depth test: the triangle drawn last is seen", hidden,
         drawn_by([](const Hit&, const Hit&) { return true; })},
        {"first_drawn_seen", "the triangle drawn first stays", hidden,
         drawn_by([](const Hit& held, const Hit&) { return is_first_or(false, held); })},
        {"back_faces_dropped", "triangles seen from behind are not drawn", hole_and_hidden,
         drawn_by([](const Hit& held, const Hit& hit) { return !hit.back && nearer(held, hit); })},
        {"front_faces_dropped", "triangles seen from the front are not drawn", hole_and_hidden,
         drawn_by([](const Hit& held, const Hit& hit) { return hit.back && nearer(held, hit); })},
        {"every_other_triangle_dropped", "only triangles with an even id are drawn", hole_and_hidden,
         drawn_by([](const Hit& held, const Hit& hit) {
             return std::uint32_t(hit.id) % 2 == 0 && nearer(held, hit);
         })},
    };
}

}  // namespace zproof::selftest
