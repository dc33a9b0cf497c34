#include "filters/report/inspection_words.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "frame/joined.h"
#include "frame/number_text.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study;

/// Four significant digits.
std::string short_number(double value) { return with_digits(value, 4); }

std::string pair_of(const glm::dvec2& p) { return "(" + short_number(p.x) + ", " + short_number(p.y) + ")"; }

std::string rgb_in_words(const glm::dvec3& c) {
    return short_number(c.r) + " " + short_number(c.g) + " " + short_number(c.b);
}

std::string word_for(WeightFault fault) {
    switch (fault) {
        case WeightFault::blur:
            return "blur";
        case WeightFault::alias:
            return "alias";
        case WeightFault::shift:
            return "shift";
    }
    return "";
}

/// What the weights are off by, as a share of that axis of the pixel's ellipse.
double share_of(const texture::Ellipse& ellipse, const WeightFinding& f) {
    return std::abs(f.found - f.exact) / (f.is_along_major ? ellipse.major : ellipse.minor);
}

std::string one_finding(const texture::Ellipse& ellipse, const WeightFinding& f) {
    const std::string axis = f.is_along_major ? " along the major axis" : " along the minor axis";
    const std::string numbers =
        f.fault == WeightFault::shift
            ? " (the weights' centroid lies " + short_number(f.found) + " texels beside the pixel's)"
            : " (the weights spread over " + short_number(f.found) + " texels, the pixel's over " +
                  short_number(f.exact) + ")";
    return word_for(f.fault) + axis + " by " + short_number(100 * share_of(ellipse, f)) + " % of it" +
           numbers;
}

/// The largest first.
std::vector<std::string> findings_in_words(const PixelInspection& one) {
    std::vector<WeightFinding> sorted = one.findings;
    std::ranges::stable_sort(sorted, std::greater{},
                             [&](const WeightFinding& f) { return share_of(one.ellipse, f); });
    std::vector<std::string> words;
    for (const WeightFinding& f : sorted) words.push_back(one_finding(one.ellipse, f));
    return words;
}

std::string level_in_words(const glm::dvec2& level) {
    return level.x == level.y ? short_number(level.x)
                              : short_number(level.x) + " along u and " + short_number(level.y) + " along v";
}

/// The mean level, each image by its weight; nothing where an image is no level, or weights cancel.
std::optional<glm::dvec2> mean_level(const Reading& reading) {
    glm::dvec2 sum{0};
    double weight = 0;
    for (const ImageRead& image : reading.images) {
        if (!image.level) return std::nullopt;
        sum += image.weight * *image.level;
        weight += image.weight;
    }
    return weight > 0 ? std::optional{sum / weight} : std::nullopt;
}

std::string what_is_read(const PixelInspection& one) {
    const auto level = mean_level(*one.reading);
    const std::string axis = " for a minor axis of " + short_number(one.ellipse.minor) + " texels";
    return level ? "reads level " + level_in_words(*level) + axis
                 : "reads " + counted(one.reading->taps.size(), "tap") + axis;
}

std::string spread_along(const PixelInspection& one, const texture::KernelShape& shape) {
    const glm::dvec2 major = one.ellipse.major_direction, minor{-major.y, major.x};
    const auto along = [&](const glm::dvec2& axis) {
        return short_number(std::sqrt(std::max(0.0, glm::dot(axis, shape.covariance * axis))));
    };
    return along(major) + " texels along the major axis, " + along(minor) + " along the minor axis";
}

std::string line(const std::string& name, const std::string& text) {
    return "  " + name + std::string(std::max<std::size_t>(1, 12 - name.size()), ' ') + text + "\n";
}

std::string weights_line(const PixelInspection& one, const std::string& name, const texture::Kernel& kernel,
                         const texture::KernelShape& shape) {
    return line(name, "sum " + short_number(shape.sum) + " over " + size_text(kernel.width, kernel.height) +
                          " texels; centroid " + pair_of(shape.centroid) + "; spread " +
                          spread_along(one, shape));
}

std::string footprint_lines(const PixelInspection& one) {
    const texture::Footprint& f = one.footprint;
    const texture::Ellipse& e = one.ellipse;
    return line("texture", size_text(one.texture_width, one.texture_height) + " texels") +
           line("footprint", "centre " + pair_of(f.centre) + ", per pixel in x " + pair_of(f.per_x) +
                                 ", in y " + pair_of(f.per_y) + " texels") +
           line("ellipse", "axes " + short_number(e.major) + " and " + short_number(e.minor) +
                               " texels, anisotropy " + short_number(e.major / e.minor) +
                               ", major axis along " + pair_of(e.major_direction));
}

std::string image_lines(const Reading& reading) {
    std::string text;
    for (const ImageRead& image : reading.images)
        text += line("reads", (image.level ? "level " + level_in_words(*image.level)
                                           : "image " + std::to_string(image.image)) +
                                  " of " + size_text(image.width, image.height) + ": " +
                                  counted(image.taps, "tap") + " of weight " + short_number(image.weight));
    return text;
}

std::string tap_lines(const Reading& reading) {
    std::string text = line("taps", "image column row weight value (r g b)");
    for (std::size_t i = 0; i < std::min(most_listed_taps, reading.taps.size()); ++i) {
        const auto& [tap, value] = reading.taps[i];
        text += line("", std::to_string(tap.image) + " " + std::to_string(tap.column) + " " +
                             std::to_string(tap.row) + " " + short_number(tap.weight) + " " +
                             rgb_in_words(value));
    }
    if (reading.taps.size() > most_listed_taps)
        text += line("", counted(reading.taps.size() - most_listed_taps, "further tap"));
    return text;
}

}  // namespace

std::string why(const PixelInspection& one) {
    if (one.texture_width == 0) return "no texture is seen at the pixel's centre";
    if (!one.reading) return "not told: nobody records what this sampler reads";
    const std::string begin = what_is_read(one) + ": ";
    if (!one.exact) return begin + "not told, since the truth is sampled there";
    if (one.exact->wraps) return begin + "not told, since the pixel covers more than the texture";
    if (one.findings.empty()) return begin + "none of blur, alias and shift";
    return begin + joined(findings_in_words(one), "; ");
}

std::string in_a_line(const PixelInspection& one) {
    return "pixel " + std::to_string(one.x) + "," + std::to_string(one.y) + ", " + one.label + ": " +
           why(one) + "\n";
}

std::string in_words(const PixelInspection& one) {
    std::string text = in_a_line(one);
    if (one.texture_width == 0) return text;
    text += footprint_lines(one);
    if (one.reading) {
        text += image_lines(*one.reading);
        text += weights_line(one, "weights", one.reading->kernel, one.reading->shape);
    }
    if (one.exact) text += weights_line(one, "exact", one.exact->kernel, one.exact->shape);
    if (one.reading)
        text += tap_lines(*one.reading) +
                line("result", rgb_in_words(one.result) + " = factor " + rgb_in_words(one.factor) +
                                   " x the sum of weight x value");
    if (one.exact)
        text +=
            line("exact mean", rgb_in_words(one.factor * one.exact->mean) + " of the texels of this surface");
    return text;
}

namespace {

std::string float_in_words(float value) { return with_digits(double(value), 9); }

std::string channel_line(const std::string& name, float value, float least, float greatest) {
    const double outside = distance_outside(value, least, greatest);
    const std::string permitted =
        least > greatest ? "permitted no float32"
                         : "permitted " + float_in_words(least) + " to " + float_in_words(greatest);
    return line(name, float_in_words(value) + ", " + permitted + ": " +
                          (outside > 0 ? "outside by " + short_number(outside) : "within"));
}

double distance_outside(const ClaimedPixel& claimed) {
    return zproof::distance_outside(claimed.value, claimed.permitted.least, claimed.permitted.greatest);
}

}  // namespace

bool is_outside(const ClaimedPixel& claimed) { return distance_outside(claimed) > 0; }

std::string in_a_line(const ClaimedPixel& claimed) {
    const std::string outside =
        is_outside(claimed) ? "outside by " + short_number(distance_outside(claimed)) + " of" : "within";
    return "the picture is " + outside + " what " + claimed.method + " permits" +
           (claimed.promise.empty() ? "" : ", promising " + claimed.promise) + "\n";
}

std::string in_words(const ClaimedPixel& claimed) {
    const auto& [least, greatest] = claimed.permitted;
    const LinearRgb& value = claimed.value;
    return in_a_line(claimed) + channel_line("red", value.r, least.r, greatest.r) +
           channel_line("green", value.g, least.g, greatest.g) +
           channel_line("blue", value.b, least.b, greatest.b);
}

}  // namespace zproof
