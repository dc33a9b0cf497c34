#include "compare/diagnosis/attribute_readings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "math/rounding.h"

namespace zproof {

namespace {

/// float32 roundings of a turned vector or an affine function: three products, two sums, the store.
const double turned = gamma(6, unit_roundoff_float32);

using Vector = glm::dvec3;

Vector vector_of(const AttributeValues& v) {
    return {v.values[0].value, v.values[1].value, v.values[2].value};
}

/// The told values are read as these, which are rounded by so much.
AttributeValues with_values(AttributeValues v, const Vector& read, double rounding) {
    for (int axis = 0; axis < int(v.values.size()); ++axis) {
        v.values[std::size_t(axis)].value = float(read[axis]);
        v.values[std::size_t(axis)].further_slack = rounding;
    }
    return v;
}

AttributeValues with_corners(AttributeValues v, const std::array<Vector, 3>& at_corners, double rounding) {
    for (int axis = 0; axis < int(v.values.size()); ++axis) {
        ReadValue& value = v.values[std::size_t(axis)];
        value.at_corners = {at_corners[0][axis], at_corners[1][axis], at_corners[2][axis]};
        value.further_slack = rounding;
    }
    return v;
}

/// Each told vector is the right one, changed by a function that `back` undoes.
AttributeReading changed_by(Cause cause, std::function<Vector(const Vector&)> back) {
    return {
        std::move(cause),
        [back = std::move(back)](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
            const Vector told = vector_of(v), read = back(told);
            return with_values(v, read, turned * std::max(length(told), length(read)));
        }};
}

std::string noun(Attribute attribute) {
    switch (attribute) {
        case Attribute::barycentrics:
            return "barycentric weights";
        case Attribute::uv:
            return "uv";
        case Attribute::normal:
            return "normals";
        case Attribute::position:
            return "positions";
    }
    return "";
}

/// "uv is", "normals are".
std::string subject(Attribute attribute) {
    return noun(attribute) + (attribute == Attribute::uv ? " is" : " are");
}

/// Over a triangle whose corners lie at one depth, each on its ray, perspective changes nothing.
AttributeReading without_perspective(Attribute attribute) {
    return {{subject(attribute) + " interpolated without perspective",
             "Values are interpolated linearly over the image.",
             "Look at the interpolation: divide values and 1 by w, interpolate both, and divide again."},
            [](const AttributePixel& pixel, AttributeValues v) -> std::optional<AttributeValues> {
                const Camera& c = pixel.view.camera;
                if (c.projection != Projection::perspective) return std::nullopt;
                const Vector eye(c.eye_world);
                for (glm::vec3& p : v.p_world) {
                    const double depth = -dot(c.back, Vector(p) - eye);
                    if (depth <= 0) return std::nullopt;
                    p = glm::vec3(eye + (Vector(p) - eye) / depth);
                }
                return v;
            }};
}

/// A half float has 11 significant bits, and steps of 2^-24 below 2^-14.
double half_float_step(double value) {
    const int exponent = value == 0 ? -14 : std::max(-14, std::ilogb(value));
    return std::ldexp(1.0, exponent - 10);
}

AttributeReading half_floats(Attribute attribute) {
    return {{subject(attribute) + " told as half floats", "Values were rounded to 11 significant bits.",
             "Look at the format of the attachment or file: 16 bits hold 11 significant ones."},
            [](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
                for (ReadValue& value : v.values) {
                    const double step = half_float_step(value.value);
                    if (std::remainder(double(value.value), step) != 0) return std::nullopt;
                    value.further_slack = step;
                }
                return v;
            }};
}

std::vector<AttributeReading> of_weights() {
    std::vector<AttributeReading> all;
    for (const auto& [order, text] : {std::pair{std::array<std::size_t, 3>{2, 0, 1}, "0 and 1"},
                                      {{1, 2, 0}, "2 and 0"},
                                      {{0, 2, 1}, "2 and 1"},
                                      {{1, 0, 2}, "0 and 2"},
                                      {{2, 1, 0}, "1 and 0"}})
        all.push_back({{"barycentric weights are in another order",
                        std::string("The two weights are those of corners ") + text + ", not 1 and 2.",
                        "Look at which corner each weight belongs to: bary.u is the second's, bary.v the "
                        "third's."},
                       [order](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
                           for (ReadValue& value : v.values) {
                               const auto declared = value.at_corners;
                               for (std::size_t i = 0; i < 3; ++i) value.at_corners[i] = declared[order[i]];
                           }
                           return v;
                       }});
    return all;
}

/// Told is 1 minus the value.
AttributeReading flipped(std::size_t axis, const std::string& name) {
    return {{"uv's " + name + " is flipped", name + " is told as 1 - " + name + ".",
             "Look at where images begin: glTF's v is 0 at the top row, OpenGL's at the bottom one."},
            [axis](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
                ReadValue& value = v.values[axis];
                value.further_slack = turned * (1 + std::abs(double(value.value)));
                value.value = float(1 - double(value.value));
                return v;
            }};
}

/// Told is the part after the point: whichever whole number between those of the corners is missing.
std::optional<AttributeValues> read_unwrapped(const AttributePixel&, AttributeValues v) {
    constexpr double most_turns = 64;
    v.alternatives.resize(v.values.size());
    for (std::size_t axis = 0; axis < v.values.size(); ++axis) {
        const ReadValue& told = v.values[axis];
        if (told.value < 0 || told.value > 1) return std::nullopt;
        const auto [low, high] = std::ranges::minmax(told.at_corners);
        if (!(high - low < most_turns)) return std::nullopt;
        for (double turns = std::floor(low) - 1; turns <= std::floor(high) + 1; ++turns) {
            ReadValue read = told;
            read.value = float(turns + double(told.value));
            read.further_slack = turned * (std::abs(turns) + 1);
            v.alternatives[axis].push_back(read);
        }
    }
    return v;
}

std::vector<AttributeReading> of_uv(const Scene& scene) {
    std::vector<AttributeReading> all{
        flipped(1, "v"),
        flipped(0, "u"),
        {{"u and v are exchanged", "u is told as v, and v as u.",
          "Look at the order of channels and at transposed images."},
         [](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
             std::swap(v.values[0].at_corners, v.values[1].at_corners);
             return v;
         }}};
    for (std::size_t set = 1; set < scene.vertices.uv.size(); ++set)
        all.push_back(
            {{"uv is of another set", "uv is that of set " + std::to_string(set) + ", not of set 0.",
              "Look at the attribute's number: TEXCOORD_0 is judged."},
             [set](const AttributePixel& pixel, AttributeValues v) -> std::optional<AttributeValues> {
                 const auto& uv = pixel.scene.vertices.uv[set];
                 const glm::uvec3 t = pixel.scene.triangles[pixel.triangle];
                 const auto at = [&](std::uint32_t i) { return Vector(uv[i], 0); };
                 return with_corners(v, {at(t.x), at(t.y), at(t.z)}, 0);
             }});
    all.push_back({{"uv is wrapped into 0 to 1", "Whole numbers are cut off, as a repeated texture does.",
                    "Look at whether uv is told before or after the sampler wraps it."},
                   read_unwrapped});
    return all;
}

/// Twice the triangle's area along its normal.
Vector area_vector(const CornersWorld& p) {
    return cross(Vector(p[1]) - Vector(p[0]), Vector(p[2]) - Vector(p[0]));
}

/// By area, over all triangles that have a corner at one place.
class SmoothNormals {
  public:
    explicit SmoothNormals(const Scene& scene) {
        for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
            const CornersWorld p = corners_of(scene, i);
            for (const glm::vec3& corner : p) sums_[key(corner)] += area_vector(p);
        }
    }
    Vector at(const glm::vec3& place) const { return sums_.at(key(place)); }

  private:
    using Key = std::tuple<float, float, float>;
    static Key key(const glm::vec3& p) { return {p.x, p.y, p.z}; }

    std::map<Key, Vector> sums_;
};

AttributeReading flat_normals() {
    return {{"normals are the triangles'", "A normal is that of the triangle's plane, not of its corners.",
             "Look at shading: interpolate the corners' normals; check that they are exported."},
            [](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
                const auto& p = v.p_world;
                const Vector normal = area_vector(p);
                const double size = length(normal);
                const double edges =
                    length(Vector(p[1]) - Vector(p[0])) * length(Vector(p[2]) - Vector(p[0]));
                if (!(size > 0)) return std::nullopt;
                const Vector unit = normal / size;
                return with_corners(v, {unit, unit, unit}, turned * edges / size);
            }};
}

AttributeReading of_one_corner() {
    return {{"normals are the first corner's", "A normal is that of the triangle's first corner everywhere.",
             "Look for flat interpolation: the provoking corner's value is not interpolated."},
            [](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
                for (ReadValue& value : v.values) value.at_corners.fill(value.at_corners[0]);
                return v;
            }};
}

AttributeReading smooth_normals(const Scene& scene) {
    const auto smooth = std::make_shared<std::unique_ptr<SmoothNormals>>();
    return {{"normals are smooth where the scene's are flat",
             "A corner's normal is the mean of all triangles that meet there, by their areas.",
             "Look at the import: normals were made anew, or corners at one place were joined."},
            [smooth, &scene](const AttributePixel&, AttributeValues v) -> std::optional<AttributeValues> {
                if (!*smooth) *smooth = std::make_unique<SmoothNormals>(scene);
                std::array<Vector, 3> at_corners;
                for (std::size_t i = 0; i < 3; ++i) {
                    const Vector sum = (*smooth)->at(v.p_world[i]);
                    if (!(length(sum) > 0)) return std::nullopt;
                    at_corners[i] = sum / length(sum);
                }
                return with_corners(v, at_corners, turned);
            }};
}

/// Axes that are turned or exchanged, of directions and of places alike.
std::vector<AttributeReading> of_other_axes(Attribute attribute, const Camera& c) {
    const std::string of = noun(attribute);
    const Vector origin = attribute == Attribute::position ? Vector(c.eye_world) : Vector(0);
    const char* axes = "Look at the export's axes: y is up here, and z is in other programs.";
    return {changed_by({of + " have the wrong sign", "Told is minus the value.",
                        "Look at the winding that normals are made by, and at axes that are negated."},
                       [](const Vector& v) { return -v; }),
            changed_by({of + " are in camera space", "Told is what the view matrix makes of the value.",
                        "Look at the matrix: world space is judged, not camera space."},
                       [=](const Vector& v) { return origin + v.x * c.right + v.y * c.up + v.z * c.back; }),
            changed_by({of + " have z up instead of y", "(x, y, z) is told as (x, -z, y).", axes},
                       [](const Vector& v) { return Vector(v.x, v.z, -v.y); }),
            changed_by({of + " have y and z exchanged", "(x, y, z) is told as (x, z, y).", axes},
                       [](const Vector& v) { return Vector(v.x, v.z, v.y); }),
            changed_by({of + " are turned about x", "(x, y, z) is told as (x, z, -y).", axes},
                       [](const Vector& v) { return Vector(v.x, -v.z, v.y); })};
}

std::vector<AttributeReading> of_normals(const Scene& scene) {
    return {changed_by({"normals are told as colours", "n is told as n / 2 + 1/2.",
                        "Look at the export: a normal map's colours are to be turned back, 2 c - 1."},
                       [](const Vector& v) { return 2.0 * v - Vector(1); }),
            flat_normals(), of_one_corner(), smooth_normals(scene)};
}

std::vector<AttributeReading> of_positions(const Camera& c) {
    const Vector eye(c.eye_world);
    return {changed_by({"positions are relative to the eye", "The eye's place is subtracted.",
                        "Look at camera-relative rendering: add the eye again."},
                       [eye](const Vector& v) { return eye + v; })};
}

}  // namespace

std::vector<AttributeReading> readings_of(Attribute attribute, const Scene& scene, const View& view) {
    std::vector<AttributeReading> all;
    const auto add = [&](const std::vector<AttributeReading>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    if (attribute == Attribute::barycentrics) add(of_weights());
    if (attribute == Attribute::uv) add(of_uv(scene));
    if (attribute == Attribute::normal || attribute == Attribute::position)
        add(of_other_axes(attribute, view.camera));
    if (attribute == Attribute::normal) add(of_normals(scene));
    if (attribute == Attribute::position) add(of_positions(view.camera));
    add({without_perspective(attribute), half_floats(attribute)});
    return all;
}

}  // namespace zproof
