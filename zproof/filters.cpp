#include "zproof/filters.h"

#include "filters/area/area_integral.h"
#include "image_io/image_io.h"
#include "scenes/judged_ranges.h"
#include "zproof/data.h"
#include "zproof/errors.h"

namespace zproof::api {
namespace {

oracle::Reconstruction reconstruction_of(const std::string& word) {
    if (const auto reconstruction = oracle::reconstruction_of(word)) return *reconstruction;
    std::string known;
    for (const auto& [letters, reconstruction] : oracle::reconstructions)
        known += (known.empty() ? "" : ", ") + std::string{letters};
    throw InputError{"truth: '" + word + "' is no reconstruction; expected one of " + known};
}

}  // namespace

Truth truth(const Scene& scene, const View& view, const std::string& reconstruction) {
    return told_as_input_error([&] {
        require_judged(view.data().view);
        const oracle::AreaTruth exact =
            oracle::area_truth(scene.data().scene, view.data().view, reconstruction_of(reconstruction));
        Truth told{.size = view.size(), .rgb = {}, .half_width = {}};
        told.rgb.reserve(3 * view.size().pixel_count());
        for (const glm::dvec3& mean : exact.mean.pixels())
            for (int channel = 0; channel < 3; ++channel) told.rgb.push_back(float(mean[channel]));
        for (const double half_width : exact.half_width.pixels())
            told.half_width.push_back(float(half_width));
        return told;
    });
}

void save_picture(const std::string& file, Size size, std::span<const float> rgb) {
    if (rgb.size() != 3 * size.pixel_count())
        throw InputError{"save_picture: " + std::to_string(rgb.size()) + " values; expected 3 x " +
                         std::to_string(size.width) + " x " + std::to_string(size.height)};
    Picture picture({size.width, size.height});
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        picture.pixels()[i] = {rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]};
    told_as_input_error([&] { write_picture(file, picture); });
}

LoadedPicture load_picture(const std::string& file) {
    return told_as_input_error([&] {
        const Picture picture = read_picture(file);
        LoadedPicture loaded{.size = {picture.size().width, picture.size().height}, .rgb = {}};
        loaded.rgb.reserve(3 * picture.pixels().size());
        for (const LinearRgb& colour : picture.pixels())
            for (const float channel : {colour.r, colour.g, colour.b}) loaded.rgb.push_back(channel);
        return loaded;
    });
}

}  // namespace zproof::api
