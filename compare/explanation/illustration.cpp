#include "compare/explanation/illustration.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/adjudicate/triangle_search.h"
#include "compare/explanation/storyteller.h"

namespace zproof {

namespace {

/// Scaled so that its value is a distance.
Affine<double> as_distance(const Affine<double>& edge) { return (1 / std::hypot(edge.a, edge.b)) * edge; }

std::optional<NearbyImage> image_at(const Sight<double>& sight, const Scene& scene, std::uint32_t triangle) {
    const auto image = image_of(sight, corners<double>(corners_of(scene, triangle)));
    if (!image) return std::nullopt;
    return NearbyImage{
        PrimitiveId(triangle),
        {as_distance(image->edge[0]), as_distance(image->edge[1]), as_distance(image->edge[2])},
        image->nearness};
}

bool is_finite(const NearbyImage& image) {
    const auto finite = [](const Affine<double>& f) {
        return std::isfinite(f.a) && std::isfinite(f.b) && std::isfinite(f.c);
    };
    return std::ranges::all_of(image.edge, finite) && finite(image.nearness);
}

/// May it come within reach of the centre? Each edge is asked by itself: too many is harmless.
bool may_reach(const NearbyImage& image, double reach_px) {
    return std::ranges::all_of(image.edge, [&](const Affine<double>& e) {
        return e.c + reach_px * (std::abs(e.a) + std::abs(e.b)) >= 0;
    });
}

std::vector<NearbyImage> images_at(const Scene& scene, const View& view, const Site& site, std::size_t most) {
    const Sight<double> sight(view, site.x, site.y);
    std::vector<NearbyImage> images;
    for (const std::uint32_t triangle : site.triangles)
        if (auto image = image_at(sight, scene, triangle);
            image && is_finite(*image) && may_reach(*image, site.reach_px))
            images.push_back(std::move(*image));
    std::ranges::stable_sort(images, std::greater<>{}, [](const NearbyImage& i) { return i.nearness.c; });
    if (images.size() > most) images.resize(most);
    return images;
}

}  // namespace

std::vector<std::vector<NearbyImage>> images_around(const Scene& scene, const View& view,
                                                    std::span<const PixelPlace> places, double reach_px,
                                                    std::size_t most) {
    std::vector<Site> sites;
    for (const PixelPlace& place : places) sites.push_back({place.x, place.y, reach_px, {}});
    find_nearby_triangles(scene, view, sites);
    std::vector<std::vector<NearbyImage>> images;
    for (const Site& site : sites) images.push_back(images_at(scene, view, site, most));
    return images;
}

std::vector<IllustratedStory> illustrate(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                         const RenderedFrame& reference, const IllustratedPlaces& places) {
    const Storyteller teller(scene, view, candidate, reference);
    std::vector<PixelStory> stories = teller.begin(places.places);
    std::vector<Site> sites;
    for (const PixelStory& story : stories) sites.push_back(site_of(story, places.reach_px));
    find_nearby_triangles(scene, view, sites);
    std::vector<IllustratedStory> told(stories.size());
    tbb::parallel_for(std::size_t(0), stories.size(), [&](std::size_t i) {
        Site drawn = sites[i], told_of = sites[i];
        told_of.reach_px = stories[i].finding.eps_px;
        drawn.reach_px = places.reach_px;
        teller.finish(stories[i], told_of);
        told[i] = {std::move(stories[i]), images_at(scene, view, drawn, places.most)};
    });
    return told;
}

}  // namespace zproof
