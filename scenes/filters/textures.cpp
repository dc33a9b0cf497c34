#include "scenes/filters/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "math/srgb.h"
#include "scenes/suite/random.h"
#include "scenes/suite/unit_circle.h"

namespace zproof::filters {

namespace {

Image grey_image(const std::string& name, TextureSize size, const std::function<double(int, int)>& value) {
    return image_of(name, size, [&](int column, int row) { return glm::dvec3(value(column, row)); });
}

/// Share of [texel, texel + 1) that lies in even fields, fields being `field` texels wide from `offset` on.
double even_share(int texel, double field, double offset) {
    const auto even_below = [&](double place) {  // length of the even fields below a place
        const double periods = std::floor(place / (2 * field)), rest = place - periods * 2 * field;
        return periods * field + std::min(rest, field);
    };
    return even_below(texel + 1 - offset) - even_below(texel - offset);
}

/// Smooth noise of `cells` cells across and down in [0, 1], repeating: lattice values blended by 3t^2 - 2t^3.
double smooth_noise(glm::dvec2 place, int cells, std::uint64_t seed) {
    const glm::dvec2 low = glm::floor(place), t = place - low, blend = t * t * (3.0 - 2.0 * t);
    const auto value = [&](int right, int down) {
        return suite::lattice_value((int(low.x) + right) % cells, (int(low.y) + down) % cells, seed);
    };
    return glm::mix(glm::mix(value(0, 0), value(1, 0), blend.x), glm::mix(value(0, 1), value(1, 1), blend.x),
                    blend.y);
}

}  // namespace

std::uint8_t srgb_code(double linear) { return std::uint8_t(std::lround(255 * encoded_srgb(linear))); }

Image image_of(const std::string& name, TextureSize size, const Colour& colour) {
    Image image{.name = name, .width = size.width, .height = size.height, .texels = {}};
    image.texels.reserve(4 * std::size_t(size.width) * std::size_t(size.height));
    for (int row = 0; row < size.height; ++row)
        for (int column = 0; column < size.width; ++column) {
            const glm::dvec3 linear = colour(column, row);
            for (int c = 0; c < 3; ++c) image.texels.push_back(srgb_code(linear[c]));
            image.texels.push_back(255);
        }
    return image;
}

Image lattice_checks() {
    return grey_image("lattice checks", {},
                      [](int column, int row) { return (column / 32 + row / 32) % 2 == 0 ? 1.0 : 0.0; });
}

Image checks(TextureSize size) {
    const double across = size.width / 18.0, down = size.height / 14.0;
    return grey_image("checks", size, [=](int column, int row) {
        const double even_column = even_share(column, across, std::sqrt(2.0)),
                     even_row = even_share(row, down, std::sqrt(3.0));
        return even_column * even_row + (1 - even_column) * (1 - even_row);
    });
}

Image zone_plate() {
    return grey_image("zone plate", {}, [](int column, int row) {
        const double x = column + 0.5 - 256, y = row + 0.5 - 256;
        return 0.5 + 0.5 * suite::unit_circle((x * x + y * y) / 1024).x;  // the phase is pi r^2 / 512
    });
}

Image white_noise() {
    std::mt19937 dice(1234);
    return grey_image("white noise", {}, [&](int, int) { return double(dice()) * 0x1p-32; });
}

Image pink_noise(TextureSize size) {
    return grey_image("pink noise", size, [=](int column, int row) {
        const glm::dvec2 place{(column + 0.5) / size.width, (row + 0.5) / size.height};
        double sum = 0, strength = 0;
        for (int cells = 4, octave = 0; cells <= 256; cells *= 2, ++octave) {
            sum += smooth_noise(place * double(cells), cells, 97 + std::uint64_t(octave)) / cells;
            strength += 1.0 / cells;
        }
        return sum / strength;
    });
}

Image lines() {
    return grey_image("lines", {},
                      [](int column, int row) { return column % 16 < 2 || row % 16 < 2 ? 0.0 : 1.0; });
}

Image impulses() {
    return grey_image("impulses", {},
                      [](int column, int row) { return column % 32 == 7 && row % 32 == 19 ? 1.0 : 0.0; });
}

Image strips() {
    std::mt19937 dice(1234);
    return grey_image("strips", {}, [&](int column, int) {
        return (column / 8 % 2 == 0 ? 0.0 : 0.6) + 0.3 * (double(dice()) * 0x1p-32);
    });
}

Image coloured_octaves() {
    const std::array<glm::dvec3, 7> hues{
        {{1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, 1, -1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, 1}}};
    return image_of("coloured octaves", {}, [&](int column, int row) {
        glm::dvec3 colour(0.5);
        for (std::size_t octave = 0; octave < hues.size(); ++octave)
            colour += hues[octave] * (((column >> octave) + (row >> octave)) % 2 == 0 ? 1.0 / 14 : -1.0 / 14);
        return colour;
    });
}

}  // namespace zproof::filters
