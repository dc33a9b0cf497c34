#include "filters/reference/shared_images.h"

namespace zproof::oracle::filter_reference {

namespace {

MethodReference nearest_reference(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_level(image, settings), wrap = settings.wrap](const FilterQuery& q) {
        return nearest(*level, wrap, place_in(*level, *level, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision));
    };
}

MethodReference bilinear_reference(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_level(image, settings),
            wrap = settings.wrap](const FilterQuery& q) -> PermittedColours {
        const TexelInterval place = place_in(*level, *level, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision);
        return {bilinear(*level, wrap, place, q.precision)};
    };
}

}  // namespace

std::vector<Definition> point_definitions() {
    return {{"nearest", nearest_reference}, {"bilinear", bilinear_reference}};
}

}  // namespace zproof::oracle::filter_reference
