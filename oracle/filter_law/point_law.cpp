#include "oracle/filter_law/question.h"

namespace zproof::oracle::filter_law {

namespace {

Law nearest_law(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_image(image), wrap = settings.wrap](const Question& q) {
        return nearest(level, wrap, place_in(level, level, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision));
    };
}

Law bilinear_law(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_image(image), wrap = settings.wrap](const Question& q) -> PermittedColours {
        const Place place = place_in(level, level, q.seen.at(q.x + 0.5, q.y + 0.5), q.precision);
        return {bilinear(level, wrap, place, q.precision)};
    };
}

}  // namespace

std::vector<Definition> point_definitions() { return {{"nearest", nearest_law}, {"bilinear", bilinear_law}}; }

}  // namespace zproof::oracle::filter_law
