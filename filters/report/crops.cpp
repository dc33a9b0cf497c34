#include "filters/report/crops.h"

#include <algorithm>
#include <cmath>

#include "filters/study/worst_pixels.h"
#include "reports/pages/error_colours.h"
#include "reports/pictures.h"

namespace zproof {

namespace {

constexpr float most_per_pixel = 0.25f;

double sum_over(const Plane<float>& values, const CropBox& box) {
    double sum = 0;
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = box.x; x < box.x + box.width; ++x) sum += double{values.at(x, y)};
    return sum;
}

}  // namespace

std::string in_words(const CropBox& box) {
    return std::to_string(box.x) + "," + std::to_string(box.y) + "," + std::to_string(box.width) + "," +
           std::to_string(box.height);
}

std::optional<CropBox> within(const CropBox& box, Resolution size) {
    const int left = std::clamp(box.x, 0, size.width), top = std::clamp(box.y, 0, size.height);
    const int right = std::clamp(box.x + box.width, 0, size.width),
              bottom = std::clamp(box.y + box.height, 0, size.height);
    if (left >= right || top >= bottom) return std::nullopt;
    return CropBox{left, top, right - left, bottom - top};
}

ErrorTally::ErrorTally(const Picture& truth) : truth_(truth), sum_(truth.size()) {}

void ErrorTally::add(const Picture& picture) {
    for (std::size_t i = 0; i < sum_.pixels().size(); ++i) {
        const LinearRgb &a = picture.pixels()[i], &b = truth_.pixels()[i];
        const float error = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
        sum_.pixels()[i] += std::isfinite(error) ? std::min(error, most_per_pixel) : most_per_pixel;
    }
}

CropBox ErrorTally::worst(int side) const {
    const Resolution size = sum_.size();
    const int width = std::min(side, size.width), height = std::min(side, size.height);
    CropBox best{0, 0, width, height};
    double most = -1;
    for (int y = 0; y + height <= size.height; y += std::max(1, height / 3))
        for (int x = 0; x + width <= size.width; x += std::max(1, width / 3))
            if (const double sum = sum_over(sum_, {x, y, width, height}); sum > most) {
                most = sum;
                best = {x, y, width, height};
            }
    return best;
}

Plane<Rgb8> crop(const Picture& picture, const CropBox& box, int factor) {
    Picture piece({box.width * factor, box.height * factor});
    for (int y = 0; y < piece.size().height; ++y)
        for (int x = 0; x < piece.size().width; ++x)
            piece.at(x, y) = picture.at(box.x + x / factor, box.y + y / factor);
    return picture_of_light(piece);
}

Plane<Rgb8> error_crop(const Picture& picture, const Picture& truth, const CropBox& box, int factor) {
    Plane<float> errors({box.width * factor, box.height * factor});
    for (int y = 0; y < errors.size().height; ++y)
        for (int x = 0; x < errors.size().width; ++x) {
            const int column = box.x + x / factor, row = box.y + y / factor;
            errors.at(x, y) = float(study::pixel_error(picture.at(column, row), truth.at(column, row)));
        }
    return error_colours(errors, {.low = 1.0 / 1024, .high = 1});
}

}  // namespace zproof
