#include "filters/report/inspection_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "filters/report/inspection_words.h"

namespace zproof {

namespace {

using namespace study;
using JsonTree = nlohmann::json;

/// Five significant digits; null for what is not finite.
JsonTree five_digits(double value) {
    if (!std::isfinite(value)) return nullptr;
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 5).ptr;
    double rounded_value = 0;
    std::from_chars(text.data(), end, rounded_value);
    return rounded_value;
}

JsonTree numbers(const std::vector<double>& values) {
    JsonTree array = JsonTree::array();
    for (const double value : values) array.push_back(five_digits(value));
    return array;
}

JsonTree place(const glm::dvec2& p) { return {five_digits(p.x), five_digits(p.y)}; }
JsonTree colour(const glm::dvec3& c) { return {five_digits(c.r), five_digits(c.g), five_digits(c.b)}; }

JsonTree of_shape(const texture::KernelShape& shape) {
    const glm::dmat2& c = shape.covariance;
    return {{"sum", five_digits(shape.sum)},
            {"centroid", place(shape.centroid)},
            {"covariance", {five_digits(c[0][0]), five_digits(c[0][1]), five_digits(c[1][1])}}};
}

JsonTree of_window(const TextureWindow& window) {
    JsonTree colours = JsonTree::array();
    for (const glm::vec3& c : window.colour)
        for (const float channel : {c.r, c.g, c.b}) colours.push_back(five_digits(double(channel)));
    return {{"column", window.column},      {"row", window.row},
            {"width", window.width},        {"height", window.height},
            {"block", window.block},        {"colour", std::move(colours)},
            {"read", numbers(window.read)}, {"exact", numbers(window.exact)}};
}

JsonTree of_reading(const Reading& reading) {
    JsonTree taps = JsonTree::array(), images = JsonTree::array();
    for (std::size_t i = 0; i < std::min(most_listed_taps, reading.taps.size()); ++i) {
        const auto& [tap, value] = reading.taps[i];
        taps.push_back({tap.image, tap.column, tap.row, five_digits(tap.weight), five_digits(value.r),
                        five_digits(value.g), five_digits(value.b)});
    }
    for (const ImageRead& image : reading.images)
        images.push_back({{"image", image.image},
                          {"width", image.width},
                          {"height", image.height},
                          {"taps", image.taps},
                          {"weight", five_digits(image.weight)},
                          {"level", image.level ? place(*image.level) : JsonTree(nullptr)}});
    return {{"taps", std::move(taps)},
            {"taps_in_all", reading.taps.size()},
            {"images", std::move(images)},
            {"shape", of_shape(reading.shape)}};
}

JsonTree of_inspection(const PixelInspection& one) {
    JsonTree corners = JsonTree::array();
    for (const glm::dvec2& corner : parallelogram(one.footprint)) corners.push_back(place(corner));
    JsonTree object{{"x", one.x},
                    {"y", one.y},
                    {"method", one.label},
                    {"why", why(one)},
                    {"text", in_words(one)},
                    {"texture", {one.texture_width, one.texture_height}},
                    {"factor", colour(one.factor)},
                    {"result", colour(one.result)},
                    {"centre", place(one.footprint.centre)},
                    {"corners", std::move(corners)},
                    {"major", five_digits(one.ellipse.major)},
                    {"minor", five_digits(one.ellipse.minor)},
                    {"direction", place(one.ellipse.major_direction)}};
    if (one.texture_width > 0) object["window"] = of_window(one.window);
    if (one.reading) object["reading"] = of_reading(*one.reading);
    if (one.exact) object["exact"] = of_shape(one.exact->shape);
    return object;
}

}  // namespace

JsonTree to_json(const std::vector<PixelInspection>& inspections) {
    JsonTree array = JsonTree::array();
    for (const PixelInspection& one : inspections) array.push_back(of_inspection(one));
    return array;
}

}  // namespace zproof
