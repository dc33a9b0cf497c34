#include "compare/explanation/illustration.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/adjudicate/triangle_search.h"
#include "compare/explanation/explainer.h"

namespace zproof {

namespace {

/// In cuts of a region by a half-plane, a second or two of a processor. Each explanation is given as much.
constexpr std::size_t most_work_of_a_view = std::size_t{1} << 22;

/// The edge scaled so that its value is a distance.
Affine<double> as_distance(const Affine<double>& edge) { return (1 / std::hypot(edge.a, edge.b)) * edge; }

std::optional<NearbyImage> image_at(const ViewRay<double>& ray, const Scene& scene, std::uint32_t triangle) {
    const auto image = image_of(ray, corners<double>(corners_of(scene, triangle)));
    if (!image) return std::nullopt;
    return NearbyImage{
        PrimitiveId(triangle),
        {as_distance(image->edge[0]), as_distance(image->edge[1]), as_distance(image->edge[2])},
        image->inverse_depth};
}

bool is_finite(const NearbyImage& image) {
    const auto finite = [](const Affine<double>& f) {
        return std::isfinite(f.a) && std::isfinite(f.b) && std::isfinite(f.c);
    };
    return std::ranges::all_of(image.edge, finite) && finite(image.inverse_depth);
}

/// May it come within reach of the centre? Each edge is asked by itself: too many is harmless.
bool may_reach(const NearbyImage& image, double reach_px) {
    return std::ranges::all_of(image.edge, [&](const Affine<double>& e) {
        return e.c + reach_px * (std::abs(e.a) + std::abs(e.b)) >= 0;
    });
}

std::vector<NearbyImage> images_at(const Scene& scene, const View& view, const SearchPixel& search_pixel,
                                   std::size_t most) {
    const ViewRay<double> ray(view, search_pixel.x, search_pixel.y);
    std::vector<NearbyImage> images;
    for (const std::uint32_t triangle : search_pixel.triangles)
        if (auto image = image_at(ray, scene, triangle);
            image && is_finite(*image) && may_reach(*image, search_pixel.reach_px))
            images.push_back(std::move(*image));
    std::ranges::stable_sort(images, std::greater<>{},
                             [](const NearbyImage& i) { return i.inverse_depth.c; });
    if (images.size() > most) images.resize(most);
    return images;
}

}  // namespace

std::vector<IllustratedExplanation> illustrate(const Scene& scene, const View& view,
                                               const RenderedFrame& candidate, const RenderedFrame& reference,
                                               const IllustrationRequest& places) {
    const Explainer explainer(scene, view, candidate, reference);
    std::vector<PixelExplanation> explanations = explainer.begin(places.places);
    std::vector<SearchPixel> search_pixels;
    for (const PixelExplanation& explanation : explanations)
        search_pixels.push_back(search_pixel_of(explanation, places.reach_px));
    explainer.search(search_pixels);
    std::vector<IllustratedExplanation> told(explanations.size());
    const std::size_t most_work = std::min(
        Neighbourhood{}.most_work, most_work_of_a_view / std::max<std::size_t>(places.places.size(), 1));
    tbb::parallel_for(std::size_t(0), explanations.size(), [&](std::size_t i) {
        SearchPixel drawn = search_pixels[i], explained = search_pixels[i];
        explained.reach_px = explanations[i].finding.eps_px;
        drawn.reach_px = places.reach_px;
        explainer.finish(explanations[i], explained, most_work);
        told[i] = {std::move(explanations[i]), images_at(scene, view, drawn, places.most)};
    });
    return told;
}

}  // namespace zproof
