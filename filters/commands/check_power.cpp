#include "filters/commands/check_power.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "filters/conformance/picture_format.h"
#include "filters/conformance/stochastic_conformance.h"
#include "frame/joined.h"

namespace zproof {

namespace {

using selftest::ChangedDefinitions;
using selftest::DefinitionChange;
using selftest::FilterClaim;
using selftest::FilterFixture;

std::string number(double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

std::vector<Picture> pictures_of(const std::vector<PlantedDefect>& defects, const FilterFixture& fixture,
                                 const FilterClaim& claim) {
    std::vector<Picture> pictures;
    for (const PlantedDefect& defect : defects)
        pictures.push_back(selftest::picture_under(defect.change, fixture, claim));
    return pictures;
}

/// Those of which it is false.
template <class T>
std::vector<T> left(const std::vector<T>& all, const std::vector<bool>& is_done) {
    std::vector<T> rest;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!is_done[i]) rest.push_back(all[i]);
    return rest;
}

/// Defects and their pictures, until a test has refused them.
struct Suspects {
    std::vector<PlantedDefect> defects;
    std::vector<Picture> pictures;

    std::vector<std::string> take(const std::vector<bool>& is_taken) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < defects.size(); ++i)
            if (is_taken[i]) names.push_back(defects[i].change.name);
        defects = left(defects, is_taken), pictures = left(pictures, is_taken);
        return names;
    }

    template <class Test>
    std::vector<bool> tried(const Test& test) const {
        std::vector<bool> all;
        for (const Picture& picture : pictures) all.push_back(test(picture));
        return all;
    }
};

/// What the promise leaves open that a renderer may well know better, from the likeliest on.
struct BetterSetting {
    const char* word;
    bool (*is_new)(const FilterPrecision&);
    void (*set)(FilterPrecision&);
};
constexpr std::array better_settings{
    BetterSetting{"arithmetic_bits=53", [](const FilterPrecision& p) { return p.arithmetic_bits < 53; },
                  [](FilterPrecision& p) { p.arithmetic_bits = 53; }},
    BetterSetting{"displacement_px=0", [](const FilterPrecision& p) { return p.displacement_px > 0; },
                  [](FilterPrecision& p) { p.displacement_px = 0; }},
    BetterSetting{"lod_slack=0", [](const FilterPrecision& p) { return p.lod_below + p.lod_above > 0; },
                  [](FilterPrecision& p) { p.lod_below = p.lod_above = 0; }},
    BetterSetting{"coordinate_bits=53", [](const FilterPrecision& p) { return p.coordinate_bits < 53; },
                  [](FilterPrecision& p) { p.coordinate_bits = 53; }}};

/// The settings, one after the other, until pixels refuse each of the pictures.
std::vector<std::string> settings_that_prove(const std::vector<Picture>& pictures,
                                             const FilterFixture& fixture, FilterClaim claim) {
    std::vector<std::string> words;
    for (const BetterSetting& better : better_settings) {
        if (!better.is_new(claim.precision)) continue;
        better.set(claim.precision);
        words.emplace_back(better.word);
        const ChangedDefinitions definitions{fixture, claim};
        const std::vector<bool> refused =
            have_pixels_outside(pictures, definitions.as_it_is(), claim.precision);
        if (std::ranges::count(refused, false) == 0) return words;
    }
    return {};
}

/// The range of all base colours, by channel.
glm::dvec3 range_of_textures(const Scene& scene) {
    glm::dvec3 least{1}, most{0};
    for (const Material& material : scene.materials) {
        if (material.base_color.image == Texture::none) continue;
        const Image& image = scene.images[std::size_t(material.base_color.image)];
        const glm::dvec3 factor{glm::vec3{material.base_color_factor}};
        for (const glm::vec4& texel :
             texture::linear_image({image.width, image.height, image.texels, image.light}).texels) {
            least = glm::min(least, factor * glm::dvec3{glm::vec3{texel}});
            most = glm::max(most, factor * glm::dvec3{glm::vec3{texel}});
        }
    }
    return most - least;
}

double wide_share(const Conformance& found, const glm::dvec3& range) {
    std::uint64_t wide = 0;
    for (const glm::vec3& width : found.width.pixels()) {
        const glm::dvec3 beyond = glm::dvec3{width} - range / 8.0;
        wide += !(beyond.x <= 0 && beyond.y <= 0 && beyond.z <= 0);
    }
    return double(wide) / double(std::max<std::uint64_t>(found.judged, 1));
}

/// The promise without what follows from the scene: roundings on the way from its corners to coordinates.
FilterPrecision without_geometry(FilterPrecision promise) {
    promise.arithmetic_bits = promise.coordinate_bits = FilterPrecision{}.arithmetic_bits;
    promise.displacement_px = 0;
    return promise;
}

/// A method that somebody may have drawn by instead, without noticing.
std::string simpler_method(const std::string& method) {
    constexpr std::array<std::pair<std::string_view, const char*>, 12> by_beginning{
        {{"nearest", "bilinear"},
         {"bilinear", "nearest"},
         {"mip-nearest", "nearest"},
         {"trilinear-", "mip-nearest-bilinear"},
         {"brilinear", "mip-nearest-bilinear"},
         {"bicubic", "bilinear"},
         {"bspline", "bilinear"},
         {"lanczos2", "bilinear"},
         {"gaussian", "bilinear"},
         {"ewa-", "aniso-d3d11"},
         {"sat-quad", "sat-affine"},
         {"sat-affine", "sat-moment"}}};
    const auto found =
        std::ranges::find_if(by_beginning, [&](const auto& row) { return method.starts_with(row.first); });
    return found == by_beginning.end() ? "trilinear-gl" : found->second;
}

bool is_refused_by_chance(const Picture& picture, const selftest::ClaimedReference& reference) {
    return reference.is_stochastic() && stochastic_conformance(picture, [&](int x, int y) {
                                            return reference.draws_at(x, y);
                                        }).is_outside();
}

}  // namespace

std::vector<PlantedDefect> planted_defects(const FilterClaim& claim) {
    const FilterPrecision& promise = claim.precision;
    const double place = 0.5 + std::exp2(-promise.place_bits), above = 0.5 + promise.lod_above,
                 below = 0.5 + promise.lod_below;
    std::vector<PlantedDefect> all{{selftest::moved_place(number(place) + " texels along u", {place, 0})},
                                   {selftest::moved_place(number(place) + " texels along v", {0, place})},
                                   {selftest::biased_lod("LOD + " + number(above), above)},
                                   {selftest::biased_lod("LOD - " + number(below), -below)}};
    const auto add = [&](const char* name, const std::function<void(FilterClaim&)>& change) {
        all.push_back({{.name = name, .of_claim = change}, DefectKind::other});
    };
    if (claim.derivatives == texture::Derivatives::analytic)
        add("steps by 2 x 2 differences",
            [](FilterClaim& c) { c.derivatives = texture::Derivatives::quad_differences; });
    if (claim.options.max_anisotropy > 1)
        add("half the limit of anisotropy", [](FilterClaim& c) { c.options.max_anisotropy /= 2; });
    const std::string simpler = simpler_method(claim.method);
    all.push_back(
        {{.name = simpler + " instead", .of_claim = [simpler](FilterClaim& c) { c.method = simpler; }},
         DefectKind::simpler_method});
    return all;
}

CheckPower power_of(const FilterFixture& fixture, const FilterClaim& claim, const Conformance& found,
                    const JointCheck& joint) {
    CheckPower power;
    power.wide_share = wide_share(found, range_of_textures(fixture.scene));
    const selftest::ClaimedReference claimed{fixture.scene, fixture.view, claim};
    const PixelReference reference = [&](int x, int y, const FilterPrecision& precision) {
        return claimed.at(x, y, precision);
    };
    Suspects suspects{planted_defects(claim), {}};
    suspects.pictures = pictures_of(suspects.defects, fixture, claim);
    power.refused = suspects.take(have_pixels_outside(suspects.pictures, reference, claim.precision));
    const auto as_a_whole = [&](const Picture& picture) {
        return is_refused_by_chance(picture, claimed) || joint.judge(picture).leaves_promise();
    };
    std::ranges::copy(suspects.take(suspects.tried(as_a_whole)), std::back_inserter(power.refused));
    // What not even exact arithmetic refuses is no defect of this picture: it does not show.
    std::vector<bool> is_unseen =
        have_pixels_outside(suspects.pictures, reference, {.code_error = claim.precision.code_error});
    is_unseen.flip();
    suspects.take(is_unseen);
    if (suspects.defects.empty()) return power;
    const std::vector<bool> seen_without_geometry =
        have_pixels_outside(suspects.pictures, reference, without_geometry(claim.precision));
    constexpr FilterPrecision in_codes{.code_error = 0.5};
    const Picture right_codes = as_stored(selftest::picture_under({}, fixture, claim), in_codes);
    std::vector<Picture> unproven;
    for (std::size_t i = 0; i < suspects.defects.size(); ++i) {
        const auto& [change, kind] = suspects.defects[i];
        power.admitted.push_back(change.name);
        if (kind == DefectKind::other) continue;
        const bool is_visible =
            !std::ranges::equal(as_stored(suspects.pictures[i], in_codes).pixels(), right_codes.pixels());
        if (kind == DefectKind::simpler_method && !(seen_without_geometry[i] && is_visible)) continue;
        power.unproven.push_back(change.name);
        unproven.push_back(suspects.pictures[i]);
    }
    if (!unproven.empty()) power.settings = settings_that_prove(unproven, fixture, claim);
    return power;
}

std::vector<std::string> in_words(const CheckPower& power, const Conformance& found) {
    std::ostringstream widths;
    widths << std::setprecision(2) << "permitted on the average: " << found.mean_width_of.x << ", "
           << found.mean_width_of.y << ", " << found.mean_width_of.z << " (R, G, B); " << std::setprecision(3)
           << 100 * power.wide_share << " % of the pixels permit more than 1/8 of the textures' range";
    std::vector<std::string> lines{widths.str()};
    if (!power.refused.empty()) lines.push_back("would refuse: " + joined(power.refused));
    if (!power.admitted.empty()) lines.push_back("would not refuse: " + joined(power.admitted));
    if (power.proves_something()) return lines;
    if (power.unproven.empty())
        lines.push_back("proves nothing: no defect shows in this picture; choose one with texels and levels");
    else if (!power.settings.empty())
        lines.push_back("proves nothing: where the renderer is so good, promise " +
                        joined(power.settings, ","));
    else
        lines.push_back(
            "proves nothing: no promise helps; choose a picture with larger texels and nearer corners");
    return lines;
}

}  // namespace zproof
