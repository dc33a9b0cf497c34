#include "filters/study/crow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "filters/methods/catalogue.h"

namespace zproof::study {

namespace {

using texture::Footprint;

constexpr int image_side = 64, places = 256;

/// What each question is put to; those that the catalogue lacks are left out.
constexpr std::array asked{"nearest",    "trilinear-gl", "trilinear-area", "ripmap",
                           "sat-affine", "sat-moment",   "aniso-d3d11",    "ewa-true"};

/// White noise in all channels alike.
texture::LinearImage noise() {
    std::mt19937 random{1984};
    texture::LinearImage image{image_side, image_side, {}};
    for (int i = 0; i < image_side * image_side; ++i)
        image.texels.emplace_back(glm::vec3{float(random() >> 8) * 0x1p-24f}, 1.0f);
    return image;
}

/// Seldom on a texel's edge or centre: multiples of irrational numbers.
glm::dvec2 place(int index) {
    const auto turned = [](double x) { return image_side * (x - std::floor(x)); };
    return {turned(0.3137 + index * 0.7548776662466927), turned(0.4811 + index * 0.5698402909980532)};
}

/// A plane seen head on, so that the footprint is the same everywhere: the whole map is affine.
Footprint footprint_of(const glm::dvec2& centre, const glm::dvec2& per_x, const glm::dvec2& per_y) {
    const glm::dvec2 origin = centre - 0.5 * (per_x + per_y);
    const Homography<double> map{{per_x.x, per_y.x, origin.x}, {per_x.y, per_y.y, origin.y}, {0, 0, 1}};
    return texture::footprint(map, 0, 0, texture::Derivatives::analytic);
}

/// The index of a texel's weight in a kernel.
std::size_t texel_index(int column, int row, int columns) {
    return std::size_t(row) * std::size_t(columns) + std::size_t(column);
}

/// One coordinate's mean and spread around the region's centre, on a line that repeats.
double deviation(const Kernel& kernel, double centre, int axis) {
    double mean = 0, square = 0;
    for (int row = 0; row < kernel.rows; ++row)
        for (int column = 0; column < kernel.columns; ++column) {
            const double weight = kernel.weights[texel_index(column, row, kernel.columns)];
            const double offset = (axis == 0 ? column : row) + 0.5 - centre;
            const double nearest = offset - image_side * std::round(offset / image_side);
            mean += weight * nearest;
            square += weight * nearest * nearest;
        }
    mean /= kernel.sum;
    return std::sqrt(std::max(0.0, square / kernel.sum - mean * mean));
}

/// Sum and deviations of the weights.
Kernel measured(Kernel kernel, const glm::dvec2& centre) {
    for (const double weight : kernel.weights) kernel.sum += weight;
    kernel.deviation = {deviation(kernel, centre.x, 0), deviation(kernel, centre.y, 1)};
    return kernel;
}

Kernel empty_kernel() {
    return {image_side, image_side, std::vector<double>(std::size_t(image_side) * image_side), 0,
            glm::dvec2{0}};
}

void add(Kernel& kernel, const texture::Share& share, double weight) {
    for (int row = share.row; row < share.row + share.rows; ++row)
        for (int column = share.column; column < share.column + share.columns; ++column)
            kernel.weights[texel_index(column, row, image_side)] += weight * share.weight;
}

Kernel kernel_of(const texture::Sampler& sampler, const Footprint& footprint) {
    Kernel kernel = empty_kernel();
    for (const texture::Tap& tap : sampler.taps(footprint))
        for (const texture::Share& share :
             sampler.stored[std::size_t(tap.image)].made_of(tap.column, tap.row))
            add(kernel, share, tap.weight);
    return measured(std::move(kernel), footprint.centre);
}

using Polygon = std::vector<glm::dvec2>;

/// The part where p[axis] >= bound, or <= it where sign is -1 (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, int axis, double bound, double sign) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = sign * (p[axis] - bound), at_q = sign * (q[axis] - bound);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) != (at_q >= 0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return kept;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i] - polygon[0], q = polygon[(i + 1) % polygon.size()] - polygon[0];
        twice += p.x * q.y - p.y * q.x;
    }
    return std::abs(twice) / 2;
}

double value_of(const Kernel& kernel, const texture::LinearImage& image) {
    double sum = 0;
    for (std::size_t i = 0; i < kernel.weights.size(); ++i)
        sum += kernel.weights[i] * double{image.texels[i].r};
    return sum;
}

/// A region of this shape, wherever it lies.
struct Shape {
    glm::dvec2 per_x, per_y;
    std::vector<double> exact;  ///< the mean at every place
};

Shape shape_of(const texture::LinearImage& image, const glm::dvec2& per_x, const glm::dvec2& per_y) {
    Shape shape{per_x, per_y, {}};
    for (int i = 0; i < places; ++i)
        shape.exact.push_back(value_of(exact_kernel(image_side, place(i), per_x, per_y), image));
    return shape;
}

CrowAnswer answer_of(const std::string& name, const texture::Sampler& sampler, const Shape& shape) {
    CrowAnswer answer{.method = name, .kernel = {}};
    double squares = 0, texels = 0;
    for (int i = 0; i < places; ++i) {
        const Footprint footprint = footprint_of(place(i), shape.per_x, shape.per_y);
        const double value = sampler.colour(footprint).r, error = value - shape.exact[std::size_t(i)];
        if (i == 0) answer.value = value;
        if (i == 0) answer.kernel = kernel_of(sampler, footprint);
        squares += error * error;
        texels += double(sampler.taps(footprint).size());
    }
    answer.texels = texels / places;
    answer.rmse = std::sqrt(squares / places);
    return answer;
}

CrowQuestion question(const texture::LinearImage& image, const std::string& region, const glm::dvec2& per_x,
                      const glm::dvec2& per_y) {
    const Shape shape = shape_of(image, per_x, per_y);
    CrowQuestion question{region, place(0), per_x, per_y, {}};
    const Kernel exact = exact_kernel(image_side, place(0), per_x, per_y);
    const auto texels = std::ranges::count_if(exact.weights, [](double weight) { return weight > 0; });
    question.answers.push_back({"exact", exact, shape.exact[0], double(texels), 0});
    for (const char* name : asked)
        if (const texture::Method* method = texture::find_method(name))
            question.answers.push_back(answer_of(name, method->prepare(image, {}), shape));
    return question;
}

BetweenLevels between_levels(const texture::LinearImage& image, double width) {
    const int level = int(std::floor(std::log2(width)));
    const double texel = std::exp2(level);
    const texture::Sampler sampler = texture::find_method("trilinear-gl")->prepare(image, {});
    const Shape shape = shape_of(image, {width, 0}, {0, width});
    return {width, level, std::log2(width) - level, width / texel - 1,
            answer_of("trilinear-gl", sampler, shape).rmse};
}

}  // namespace

Kernel exact_kernel(int texture_side, const glm::dvec2& centre, const glm::dvec2& per_x,
                    const glm::dvec2& per_y) {
    Kernel kernel{texture_side, texture_side,
                  std::vector<double>(std::size_t(texture_side) * std::size_t(texture_side)), 0,
                  glm::dvec2{0}};
    const glm::dvec2 a = 0.5 * (per_x + per_y), b = 0.5 * (per_x - per_y),
                     reach = glm::max(glm::abs(a), glm::abs(b));
    const Polygon region{centre - a, centre + b, centre + a, centre - b};
    const double whole = area(region);
    const auto wrapped = [&](int index) { return ((index % texture_side) + texture_side) % texture_side; };
    for (int row = int(std::floor(centre.y - reach.y)); row < centre.y + reach.y; ++row) {
        const Polygon strip = clipped(clipped(region, 1, row, 1), 1, row + 1, -1);
        for (int column = int(std::floor(centre.x - reach.x)); column < centre.x + reach.x; ++column) {
            const Polygon piece = clipped(clipped(strip, 0, column, 1), 0, column + 1, -1);
            if (piece.size() > 2)
                kernel.weights[texel_index(wrapped(column), wrapped(row), texture_side)] +=
                    area(piece) / whole;
        }
    }
    return measured(std::move(kernel), centre);
}

CrowAnswers crow_answers() {
    const texture::LinearImage image = noise();
    CrowAnswers answers{.texture_side = image_side, .places = places, .questions = {}, .levels = {}};
    const double slant = std::sqrt(0.5);
    answers.questions.push_back(question(image, "5 x 5", {5, 0}, {0, 5}));
    answers.questions.push_back(question(image, "16 x 2", {16, 0}, {0, 2}));
    answers.questions.push_back(
        question(image, "16 x 2, turned by 45 degrees", {16 * slant, 16 * slant}, {-2 * slant, 2 * slant}));
    for (const double width : {4.0, 4.5, 5.0, 5.5, 6.0, 6.5, 7.0, 7.5, 8.0})
        answers.levels.push_back(between_levels(image, width));
    return answers;
}

}  // namespace zproof::study
