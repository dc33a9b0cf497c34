#include "zproof/filters.h"

#include "filters/area/area_integral.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/stored/mip_chain.h"
#include "filters/study/cost.h"
#include "frame/number_text.h"
#include "image_io/image_io.h"
#include "rasterizer/textured_surface.h"
#include "rasterizer/triangle_footprints.h"
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

namespace {

LevelImage level_of(const texture::LinearImage& image) {
    LevelImage level{.size = {image.width, image.height}, .rgb = {}};
    for (const glm::vec4& texel : image.texels)
        for (const float channel : {texel.r, texel.g, texel.b}) level.rgb.push_back(channel);
    return level;
}

void add_pixel(TexturedPixels& seen, std::uint64_t pixel, const texture::Footprint& f) {
    seen.pixels.push_back(pixel);
    for (const double place : {f.centre.x, f.centre.y}) seen.coordinates.push_back(place);
    for (const double slope : {f.per_x.x, f.per_y.x, f.per_x.y, f.per_y.y}) seen.jacobian.push_back(slope);
}

/// By material; those that nothing shows are empty.
std::vector<TexturedPixels> ask_all_pixels(const zproof::Scene& scene, const zproof::View& view,
                                           FilterTask& task) {
    std::vector<TexturedPixels> by_material(scene.materials.size());
    const zproof::Frame frame = oracle::exact_visibility(scene, view);
    task.factor.resize(3 * frame.primitive.pixels().size(), 0);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const Material& material = rasterizer::material_of(scene, std::uint32_t(id));
            const std::uint64_t pixel = std::uint64_t(y) * std::uint64_t(view.width) + std::uint64_t(x);
            for (std::uint64_t c = 0; c < 3; ++c)
                task.factor[3 * pixel + c] = double(material.base_color_factor[glm::length_t(c)]);
            if (const auto footprints = rasterizer::footprints_of(scene, view, std::uint32_t(id)))
                add_pixel(by_material[std::size_t(&material - scene.materials.data())], pixel,
                          footprints->at(x, y, texture::Derivatives::analytic));
        }
    return by_material;
}

}  // namespace

FilterTask filter_task(const Scene& scene, const View& view) {
    return told_as_input_error([&] {
        require_judged(view.data().view);
        FilterTask task{.size = view.size(), .factor = {}, .textures = {}};
        std::vector<TexturedPixels> by_material = ask_all_pixels(scene.data().scene, view.data().view, task);
        const study::SourceTextures sources = study::source_textures(scene.data().scene);
        for (std::size_t i = 0; i < by_material.size(); ++i) {
            if (by_material[i].pixels.empty()) continue;
            for (const texture::LinearImage& level :
                 texture::mip_chain(sources[i]->image, texture::MipKernel::box))
                by_material[i].levels.push_back(level_of(level));
            task.textures.push_back(std::move(by_material[i]));
        }
        return task;
    });
}

void save_picture(const std::string& file, Size size, std::span<const float> rgb) {
    if (rgb.size() != 3 * size.pixel_count())
        throw InputError{"save_picture: " + std::to_string(rgb.size()) + " values; expected 3 x " +
                         size_text(size.width, size.height)};
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
