#include "filters/normals/normal_study.h"

#include <cmath>
#include <functional>

#include "filters/area/area_integral.h"
#include "filters/normals/highlight.h"
#include "filters/reference/admissible_surfaces.h"

namespace zproof::normals {

namespace {

glm::dvec3 values_of(const LinearRgb& colour) { return {colour.r, colour.g, colour.b}; }

/// The scene with other numbers on its surface.
Scene showing(const Scene& scene, const texture::LinearImage& image) {
    Scene other = scene;
    Image& shown = other.images.at(0);
    shown.width = image.width, shown.height = image.height;
    shown.texels.assign(4 * image.texels.size(), 0);
    shown.light = image.texels;
    return other;
}

texture::LinearImage highlights_of(const NormalMap& map, const Light& light) {
    texture::LinearImage image{map.width, map.height, {}};
    for (const glm::dvec3& normal : map.normals)
        image.texels.emplace_back(glm::vec3{float(blinn_phong(normal, light.half, light.shininess))}, 1.0f);
    return image;
}

/// What a filter makes of each image of a map.
struct Filtered {
    Picture normals, slopes, squares, highlights;
};

using Model = std::function<double(const Filtered&, std::size_t pixel, const Light&)>;

const std::vector<std::pair<std::string, Model>>& models() {
    static const std::vector<std::pair<std::string, Model>> all{
        {"mean normal",
         [](const Filtered& f, std::size_t i, const Light& light) {
             return of_mean_normal(values_of(f.normals.pixels()[i]), light.half, light.shininess);
         }},
        {"toksvig",
         [](const Filtered& f, std::size_t i, const Light& light) {
             return toksvig(values_of(f.normals.pixels()[i]), light.half, light.shininess);
         }},
        {"lean",
         [](const Filtered& f, std::size_t i, const Light& light) {
             const glm::dvec3 mean = values_of(f.slopes.pixels()[i]),
                              squares = values_of(f.squares.pixels()[i]);
             return lean({{mean.x, mean.y}, squares.x, squares.y, squares.z}, light.half, light.shininess);
         }},
        {"filtered highlights",
         [](const Filtered& f, std::size_t i, const Light&) { return double{f.highlights.pixels()[i].r}; }}};
    return all;
}

}  // namespace

std::vector<HighlightScore> highlight_scores(const Scene& scene, const View& view, const NormalMap& map,
                                             const Light& light, const rasterizer::Texturing& filter) {
    const Frame frame = oracle::exact_visibility(scene, view);
    const auto filtered = [&](const texture::LinearImage& image) {
        return rasterizer::filtered(showing(scene, image), view, frame, filter);
    };
    const FilteredImages images = images_to_filter(map);
    const texture::LinearImage highlights = highlights_of(map, light);
    const Filtered all{filtered(images.normals), filtered(images.slopes), filtered(images.squares),
                       filtered(highlights)};
    const oracle::AreaTruth truth =
        oracle::area_truth(showing(scene, highlights), view, oracle::Reconstruction::nearest);
    std::vector<HighlightScore> scores;
    for (const auto& [name, model] : models()) {
        double squares = 0, pixels = 0;
        for (std::size_t i = 0; i < truth.kind.pixels().size(); ++i) {
            if (truth.kind.pixels()[i] != oracle::TruthKind::interior) continue;
            squares += std::pow(model(all, i, light) - truth.mean.pixels()[i].r, 2), ++pixels;
        }
        scores.push_back({name, std::sqrt(squares / pixels)});
    }
    return scores;
}

}  // namespace zproof::normals
