#include "scenes/filters/filter_scenes.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "frame/frame_error.h"
#include "frame/number_text.h"
#include "scenes/filters/scenes.h"
#include "scenes/limits.h"
#include "scenes/scene_error.h"
#include "scenes/scene_files.h"
#include "scenes/texture_image.h"

namespace zproof {

namespace {

struct FilterGenerator {
    std::string_view name, reason;
    Loaded (*build)(filters::ImageSize size);
};

constexpr std::array filter_generators{
    FilterGenerator{
        "worked",
        "The plane of the worked set-up, checks of 32 texels to the horizon, has published figures to "
        "be held "
        "against.",
        filters::worked},
    FilterGenerator{
        "checker_plane",
        "Checks of two extents with edges at irrational places, seen at 13 angles, meet every footprint from "
        "half a texel to a thousand and no lattice.",
        filters::checker_plane},
    FilterGenerator{"zone_plate_plane",
                    "Rings of every frequency in every direction show aliases as rings elsewhere.",
                    filters::zone_plate_plane},
    FilterGenerator{
        "tunnel",
        "Sixteen walls vanish in one point, and every octave of detail has a hue, so that the level which a "
        "filter takes can be seen.",
        filters::tunnel},
    FilterGenerator{
        "tilted_quads",
        "49 fields of one affine footprint each, anisotropy 1 to 64 by long axes at 0 to 90 degrees, "
        "part what a "
        "filter does by shape.",
        filters::tilted_quads},
    FilterGenerator{
        "lod_ramp",
        "32 fields from 4 pixels a texel to 54 texels a pixel in steps of a quarter level show how "
        "levels are "
        "blended.",
        filters::lod_ramp},
    FilterGenerator{"magnification",
                    "Texels of 1.5 to 23.5 pixels, turned, show what a filter makes of too little detail.",
                    filters::magnification},
    FilterGenerator{
        "seams",
        "Every pair of wraps, with three and a half textures across, shows a wrong texel beyond an edge.",
        filters::seams},
    FilterGenerator{"lines_plane",
                    "Thin dark lines on light ground lose their strength wherever a filter is too wide.",
                    filters::lines_plane},
    FilterGenerator{"text_plane",
                    "Letters of four sizes must stay legible as far away as their texels allow.",
                    filters::text_plane},
    FilterGenerator{
        "white_noise_plane",
        "Independent texels have all frequencies alike, so that the error tells the distance of a "
        "kernel alone.",
        filters::white_noise_plane},
    FilterGenerator{"pink_noise_plane",
                    "Noise whose amplitude falls with frequency stands for what photographs are like.",
                    filters::pink_noise_plane},
    FilterGenerator{"impulse_plane", "Single white texels draw the kernel of a filter, pixel by pixel.",
                    filters::impulse_plane},
    FilterGenerator{"npot_plane", "Checks of 640 x 427 texels, sizes that halve to odd numbers.",
                    filters::npot_plane},
    FilterGenerator{
        "npot_odd_plane",
        "Noise of 257 x 129 texels, one more than a power of two, where a chain that drops columns "
        "loses most.",
        filters::npot_odd_plane},
    FilterGenerator{
        "uneven_strips",
        "Dark strips a quarter as wide on the surface as light ones, of as many texels, show a chain that "
        "takes all texels for equally large.",
        filters::uneven_strips},
};

void check_size(const std::string& name, int width, int height) {
    if (width < 1 || height < 1)
        throw SceneError("filter scene '" + name + "': the image is " + size_text(width, height) +
                         " pixels, expected at least 1 x 1");
}

std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return extension;
}

/// Formats with levels, blocks and floats.
bool is_of_levels(const std::string& extension) { return extension == ".exr" || extension == ".dds"; }

Image photograph_in(const std::filesystem::path& file) {
    const Bytes bytes = read_file(file, limits::file_bytes);
    const std::string fault = image_fault(bytes);
    if (!fault.empty()) throw std::runtime_error(fault);
    return decode_image(bytes);
}

}  // namespace

std::vector<FilterSceneEntry> filter_scenes() {
    std::vector<FilterSceneEntry> entries;
    for (const FilterGenerator& scene : filter_generators)
        entries.push_back({std::string(scene.name), std::string(scene.reason)});
    return entries;
}

Loaded generate_filter_scene(const std::string& name, int width, int height) {
    check_size(name, width, height);
    const auto generator = std::ranges::find(filter_generators, name, &FilterGenerator::name);
    if (generator == filter_generators.end())
        throw SceneError("there is no filter scene '" + name + "'; docs/filter-scenes.md lists all");
    return generator->build({.width = width, .height = height});
}

bool is_photograph(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg" || is_of_levels(extension);
}

bool is_photograph_of_floats(const std::filesystem::path& file) {
    return is_of_levels(lower_extension(file)) && is_texture_of_floats(file);
}

Loaded plane_scene(const std::string& name, Image image, int width, int height) {
    check_size(name, width, height);
    return filters::ground(name, std::move(image), {.width = width, .height = height}, 7.5);
}

Loaded photograph_scene(const std::filesystem::path& file, int width, int height) {
    try {
        Image image = is_of_levels(lower_extension(file)) ? texture_in(file) : photograph_in(file);
        const std::string name = image.name = file.filename().string();
        return plane_scene(name, std::move(image), width, height);
    } catch (const SceneError&) {
        throw;
    } catch (const FrameError& error) {
        throw SceneError(error.what());  // it names the file
    } catch (const std::runtime_error& error) {
        throw SceneError(file.string() + ": " + error.what());
    }
}

}  // namespace zproof
