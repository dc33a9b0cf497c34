#include "filters/study/inspection.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "rasterizer/textured_surface.h"
#include "rasterizer/triangle_footprints.h"

namespace zproof::study {

namespace {

using texture::BaseLevel;
using texture::Sampler;
using texture::Share;
using texture::StoredImage;
using texture::Tap;

/// A stored value is a sum of shares of level 0.
glm::dvec3 value_of(const std::vector<Share>& shares, const texture::LinearImage& image) {
    glm::dvec3 sum{0};
    for (const Share& share : shares)
        for (int row = share.row; row < share.row + share.rows; ++row)
            for (int column = share.column; column < share.column + share.columns; ++column)
                sum += share.weight * glm::dvec3{glm::vec3{image.at(column, row)}};
    return sum;
}

double weight_of(const std::vector<Share>& shares) {
    double sum = 0;
    for (const Share& share : shares) sum += share.weight * share.columns * share.rows;
    return sum;
}

/// Adds a tap to what is known of its image. An image is a level where every value read of it is a mean.
void add(std::map<int, ImageRead>& images, const Sampler& sampler, const Tap& tap, double share_weight,
         const texture::LinearImage& base) {
    const StoredImage& stored = sampler.stored[std::size_t(tap.image)];
    const glm::dvec2 level{std::log2(double(base.width) / stored.width),
                           std::log2(double(base.height) / stored.height)};
    ImageRead& read =
        images.try_emplace(tap.image, ImageRead{tap.image, stored.width, stored.height, 0, 0, level})
            .first->second;
    ++read.taps;
    read.weight += tap.weight;
    if (!(std::abs(share_weight - 1) <= alike)) read.level.reset();
}

Reading reading_of(const Sampler& sampler, const texture::Footprint& footprint, const SourceTexture& source) {
    Reading reading;
    std::map<int, ImageRead> images;
    for (const Tap& tap : sampler.taps(footprint)) {
        const std::vector<Share> shares = sampler.stored[std::size_t(tap.image)].made_of(tap.column, tap.row);
        reading.taps.push_back({tap, value_of(shares, source.image)});
        add(images, sampler, tap, weight_of(shares), source.image);
    }
    for (const auto& [index, image] : images) reading.images.push_back(image);
    reading.kernel = record(sampler, footprint, {source.image.width, source.image.height, source.addressing});
    reading.shape = shape_of(reading.kernel);
    return reading;
}

/// The texels of one material, wrapped into level 0.
ExactWeights exact_of(const std::vector<oracle::TexelWeight>& weights, int material,
                      const SourceTexture& source, const glm::dvec2& centre) {
    const int width = source.image.width, height = source.image.height;
    std::vector<Share> shares;
    std::int64_t left = INT64_MAX, right = INT64_MIN, low = INT64_MAX, high = INT64_MIN;
    for (const oracle::TexelWeight& w : weights) {
        if (w.material != material) continue;
        shares.push_back({texture::wrapped(source.addressing.u, w.column, width),
                          texture::wrapped(source.addressing.v, w.row, height), w.weight});
        left = std::min(left, w.column), right = std::max(right, w.column);
        low = std::min(low, w.row), high = std::max(high, w.row);
    }
    ExactWeights exact{kernel_of(shares, {width, height, source.addressing}, centre), {}, {}, false};
    for (const Share& share : shares)
        exact.mean += share.weight * glm::dvec3{glm::vec3{source.image.at(share.column, share.row)}};
    exact.shape = shape_of(exact.kernel);
    exact.wraps = !shares.empty() && (right - left >= width || high - low >= height);
    return exact;
}

double spread(const glm::dmat2& covariance, const glm::dvec2& axis) {
    return std::sqrt(std::max(0.0, glm::dot(axis, covariance * axis)));
}

bool differs(double a, double b) {
    return std::abs(a - b) > alike * std::max({std::abs(a), std::abs(b), 1.0});
}

}  // namespace

std::vector<WeightFinding> findings_of(const texture::Ellipse& ellipse, const texture::KernelShape& found,
                                       const texture::KernelShape& exact) {
    std::vector<WeightFinding> findings;
    const glm::dvec2 major = ellipse.major_direction, minor{-major.y, major.x};
    for (const bool is_major : {true, false}) {
        const glm::dvec2& axis = is_major ? major : minor;
        const double ours = spread(found.covariance, axis), theirs = spread(exact.covariance, axis);
        if (differs(ours, theirs))
            findings.push_back(
                {ours > theirs ? WeightFault::blur : WeightFault::alias, is_major, ours, theirs});
    }
    for (const bool is_major : {true, false}) {
        const double distance = glm::dot(is_major ? major : minor, found.centroid - exact.centroid);
        if (differs(distance, 0)) findings.push_back({WeightFault::shift, is_major, std::abs(distance), 0});
    }
    return findings;
}

namespace {

/// Not of a sampler of others, and not where levels are given: what they are made of nobody says. Where codes
/// are filtered the weights are not those of light.
bool has_known_weights(const StudyMethod& method) {
    const texture::FilterOptions& options = method.texturing.options;
    return !method.paint && !options.given_levels && options.decoding == texture::Decoding::before_filtering;
}

/// A large table of repeated sums does not tell it.
bool tells_what_it_keeps(const Sampler& sampler) {
    return std::ranges::all_of(sampler.stored, [](const auto& image) { return bool(image.made_of); });
}

/// What a method keeps of one texture, made when first asked for.
class MethodSamplers {
  public:
    MethodSamplers(const StudyMethod& method, const SourceTextures& sources)
        : method_(method), sources_(sources), made_(sources.size()) {}

    const Sampler& of(int material) {
        std::optional<Sampler>& sampler = made_[std::size_t(material)];
        if (sampler) return *sampler;
        const SourceTexture& source = *sources_[std::size_t(material)];
        return sampler.emplace(
            method_.texturing.method.prepare(source.image, source.with(method_.texturing.options)));
    }

  private:
    const StudyMethod& method_;
    const SourceTextures& sources_;
    std::vector<std::optional<Sampler>> made_;
};

}  // namespace

Inspector::Inspector(const Scene& scene, const View& view, const Frame& frame, oracle::Reconstruction truth)
    : scene_(scene),
      view_(view),
      frame_(frame),
      sources_(source_textures(scene)),
      weights_(scene, view, truth) {}

Inspector::Seen Inspector::seen_at(const StudyMethod& method, const PixelCoord& pixel) const {
    Seen seen;
    PixelInspection& one = seen.inspection;
    one.x = pixel.x, one.y = pixel.y, one.label = method.label;
    const PrimitiveId id = frame_.primitive.at(pixel.x, pixel.y);
    if (id == PrimitiveId::none) return seen;
    const Material& material = rasterizer::material_of(scene_, std::uint32_t(id));
    one.factor = glm::dvec3{glm::dvec4{material.base_color_factor}};
    one.result = one.factor;
    const auto footprints = rasterizer::footprints_of(scene_, view_, std::uint32_t(id));
    if (!footprints) return seen;
    seen.material = int(&material - scene_.materials.data());
    one.footprint = footprints->at(pixel.x, pixel.y, method.texturing.derivatives);
    one.ellipse = texture::ellipse(one.footprint);
    const texture::LinearImage& image = sources_[std::size_t(seen.material)]->image;
    one.texture_width = image.width, one.texture_height = image.height;
    return seen;
}

void Inspector::weigh(Seen& seen) const {
    PixelInspection& one = seen.inspection;
    const SourceTexture& source = *sources_[std::size_t(seen.material)];
    if (const auto weights = weights_.at(one.x, one.y))
        one.exact = exact_of(*weights, seen.material, source, one.footprint.centre);
    one.window = texture_window({.footprint = one.footprint,
                                 .read = one.reading ? &one.reading->kernel : nullptr,
                                 .exact = one.exact ? &one.exact->kernel : nullptr},
                                source.image, source.addressing, most_window_cells);
    if (!one.reading) return;
    glm::dvec3 sum{0};
    for (const ValuedTap& tap : one.reading->taps) sum += tap.tap.weight * tap.value;
    one.result = one.factor * sum;
    if (one.exact && !one.exact->wraps)
        one.findings = findings_of(one.ellipse, one.reading->shape, one.exact->shape);
}

std::vector<PixelInspection> Inspector::at(const StudyMethod& method,
                                           const std::vector<PixelCoord>& pixels) const {
    std::vector<Seen> all;
    MethodSamplers samplers(method, sources_);
    for (const PixelCoord& pixel : pixels) all.push_back(seen_at(method, pixel));
    for (const Seen& seen : all)
        if (seen.material >= 0 && has_known_weights(method)) samplers.of(seen.material);
    tbb::parallel_for(std::size_t(0), all.size(), [&](std::size_t i) {
        Seen& seen = all[i];
        if (seen.material < 0) return;
        const SourceTexture& source = *sources_[std::size_t(seen.material)];
        if (has_known_weights(method) && tells_what_it_keeps(samplers.of(seen.material)))
            seen.inspection.reading =
                reading_of(samplers.of(seen.material), seen.inspection.footprint, source);
        weigh(seen);
    });
    std::vector<PixelInspection> inspections;
    for (Seen& seen : all) inspections.push_back(std::move(seen.inspection));
    return inspections;
}

}  // namespace zproof::study
