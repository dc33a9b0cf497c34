#include "lessons/shading/report.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "math/srgb.h"
#include "reports/pages/error_colours.h"
#include "reports/wording.h"

namespace zproof {
namespace {

using namespace study::shading;
using document::Section;
using document::Table;

constexpr ErrorScale difference_scale{1e-4, 1};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c == ' ' || c == ',' ? '-' : c >= 'A' && c <= 'Z' ? char(c + 32) : c;
    });
    const auto are_dashes = [](char a, char b) { return a == '-' && b == '-'; };
    text.erase(std::unique(text.begin(), text.end(), are_dashes), text.end());
    return text;
}

/// Linear light as sRGB shows it; nothing is dark blue.
Plane<Rgb8> shown(const Plane<double>& intensity) {
    Plane<Rgb8> picture(intensity.size(), Rgb8{20, 24, 48});
    for (std::size_t i = 0; i < intensity.pixels().size(); ++i) {
        if (std::isnan(intensity.pixels()[i])) continue;
        const auto grey = std::uint8_t(std::lround(255 * encoded_srgb(intensity.pixels()[i])));
        picture.pixels()[i] = {grey, grey, grey};
    }
    return picture;
}

Plane<float> in_float(const Plane<double>& values) {
    Plane<float> floats(values.size());
    std::ranges::transform(values.pixels(), floats.pixels().begin(), [](double v) { return float(v); });
    return floats;
}

document::Picture in_group(document::Picture picture, const std::string& group) {
    picture.group = group;
    return picture;
}

Table level_table(const TessellationStudy& study) {
    Table table{
        .name = "levels",
        .caption = "A sphere cut finer and finer, against the sphere itself; intensities, 1 is the light's",
        .columns = {{"level", "", ""},
                    {"triangles", "", ""},
                    {"edge", "px", "median"},
                    {"method", "", ""},
                    {"rmse", "", ""},
                    {"largest", "", ""},
                    {"peak", "", "brightest pixel"},
                    {"sphere's peak", "", ""},
                    {"bend at edges", "", "second difference, 99 of 100 pixels have no more"},
                    {"bend inside", "",
                     "the same where no edge lies between the pixels; nan where there is no such pixel"}},
        .rows = {}};
    for (const LevelScore& s : study.scores)
        table.rows.push_back({std::int64_t{s.level}, std::int64_t(s.triangles), s.edge_px,
                              std::string{name_of(s.method)}, s.rmse, s.largest, s.peak, s.peak_of_sphere,
                              s.bend_at_edges, s.bend_inside});
    return table;
}

Table missed_table(const TessellationStudy& study) {
    Table table{
        .name = "missed-highlight",
        .caption = "Gouraud's missed highlight: no pixel is brighter than a corner",
        .columns = {{"level", "", ""},
                    {"nearest corner", "degrees", "from the highlight's centre to a normal of a corner"},
                    {"half width", "degrees", "from the centre to where the highlight has half its strength"},
                    {"brightest corner", "", "predicted: interpolation exceeds no corner"},
                    {"Gouraud's peak", "", "measured"},
                    {"sphere's peak", "", ""},
                    {"lost", "", "sphere's peak less Gouraud's"}},
        .rows = {}};
    for (const MissedHighlight& m : study.missed)
        table.rows.push_back({std::int64_t{m.level}, m.nearest_degrees, m.half_width_degrees,
                              m.predicted_peak, m.measured_peak, m.sphere_peak,
                              m.sphere_peak - m.measured_peak});
    return table;
}

/// One line per method, level by level.
template <class Value>
void add_lines(Chart& chart, const TessellationStudy& study, const std::string& what, Value value) {
    for (const Method method : all_methods) {
        Series series{.name = std::string{name_of(method)} + what, .points = {}};
        for (const LevelScore& s : study.scores)
            if (s.method == method) series.points.push_back({s.edge_px, value(s)});
        chart.series.push_back(std::move(series));
    }
}

Chart error_chart(const TessellationStudy& study) {
    Chart chart{.title = "Error against the sphere itself",
                .x = {.title = "median edge, px", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "rmse of the intensity", .scale = Scale::logarithmic, .names = {}},
                .series = {}};
    add_lines(chart, study, "", [](const LevelScore& s) { return s.rmse; });
    return chart;
}

Chart band_chart(const TessellationStudy& study) {
    Chart chart{.title = "Mach bands: the second difference of the picture",
                .x = {.title = "median edge, px", .scale = Scale::logarithmic, .names = {}},
                .y = {.title = "|I(x-1) - 2 I(x) + I(x+1)|", .scale = Scale::logarithmic, .names = {}},
                .series = {}};
    add_lines(chart, study, ", at edges", [](const LevelScore& s) { return s.bend_at_edges; });
    add_lines(chart, study, ", inside", [](const LevelScore& s) { return s.bend_inside; });
    return chart;
}

/// Group by group, for only neighbours stand side by side.
std::vector<document::Item> level_pictures(const TessellationStudy& study) {
    std::vector<document::Item> pictures, differences, bends, all;
    for (const LevelPicture& p : study.pictures) {
        if (p.level > 3) continue;
        const std::string method = name_of(p.method), level = std::to_string(p.level);
        const std::string stem = "sphere-" + level + "-" + lower(method);
        pictures.emplace_back(in_group(
            document::picture_of(stem, method + ", level " + level, shown(p.intensity)), "level " + level));
        differences.emplace_back(
            in_group(document::picture_of(stem + "-difference", method + ": difference from the sphere",
                                          error_colours(in_float(p.difference), difference_scale)),
                     "level " + level + " differences"));
        bends.emplace_back(in_group(document::picture_of(stem + "-bends", method + ": second difference",
                                                         error_colours(p.bend, difference_scale)),
                                    "level " + level + " bends"));
        if (p.method != all_methods.back()) continue;
        for (auto* group : {&pictures, &differences, &bends}) {
            std::ranges::move(*group, std::back_inserter(all));
            group->clear();
        }
    }
    return all;
}

Table scene_table(const ShadingStudy& study, const std::string& stem) {
    Table table{
        .name = stem + "-methods",
        .caption = grouped(study.pixels) + " pixels at which the rasterizer and Embree see one triangle",
        .columns = {{"light", "", ""},
                    {"highlight", "", ""},
                    {"method", "", ""},
                    {"mixing", "", ""},
                    {"rmse to Embree's", "", "the same method at Embree's hits, in double"},
                    {"largest", "", "likewise"},
                    {"predicted largest", "", "of affine mixing; nan where nothing is predicted"},
                    {"rmse to Phong", "", "Phong's method at Embree's hits"},
                    {"largest to Phong", "", ""}},
        .rows = {}};
    for (const SceneScore& s : study.scores)
        table.rows.push_back(
            {std::string{s.light_source == LightSource::Kind::directional ? "directional" : "point"},
             std::string{name_of(s.highlight)}, std::string{name_of(s.method)},
             std::string{name_of(s.mixing)}, s.rmse_to_traced, s.largest_to_traced, s.predicted_largest,
             s.rmse_to_phong, s.largest_to_phong});
    return table;
}

std::string povray_words(const PovrayScore& score) {
    if (!score.not_asked.empty()) return "POV-Ray was not asked: " + score.not_asked + ".";
    return "Phong's method against POV-Ray's smooth triangles (directional light, Phong's highlight, "
           "white): " +
           grouped(score.pixels) + " pixels differ by " + rounded(score.rmse) +
           " RMS, 99 of 100 by at most " + rounded(score.p99) + ", the worst by " + rounded(score.largest) +
           "; its picture has steps of 1/65535, 1.5e-5. " + grouped(score.turned) +
           " pixels are left out whose mixed normal points away from the eye: POV-Ray turns it over.";
}

}  // namespace

document::Document shading_document(const TessellationStudy& study) {
    document::Document document;
    document.title = "Shading: what lies between the corners";
    document.introduction = {
        "Faceted, Gouraud's and Phong's shading, in double precision, so that what differs is the method. On "
        "a "
        "sphere, which triangles only stand for, the error falls as it is cut finer: how fast, what "
        "Gouraud's "
        "interpolation does to a highlight, and where the eye sees bands. On scenes, each method is held "
        "against itself at Embree's hits, and against Phong's."};
    Section section{
        "A sphere, cut finer and finer",
        {"Level n has 20 * 4^n triangles, with the sphere's own normals at their corners. A bend is "
         "the second difference of the picture: what Mach bands are made of. Difference and bend "
         "maps: black-violet is 1e-4 and less, yellow 1, grey is nothing to compare."},
        {level_table(study), missed_table(study),
         document::Plot{"error-by-level", "Halving an edge", error_chart(study)},
         document::Plot{"bands-by-level", "Bands lie on edges", band_chart(study)}}};
    std::ranges::move(level_pictures(study), std::back_inserter(section.items));
    document.sections = {std::move(section)};
    return document;
}

Section shading_section(const ShadingStudy& study, const std::string& stem) {
    Section section{study.scene + " / " + study.view,
                    {grouped(study.other_ids) +
                         " pixels are left out because rasterizer and Embree name different triangles there. "
                         "Materials' colours are left out: they multiply every method alike.",
                     povray_words(study.povray)},
                    {scene_table(study, stem)}};
    for (const ScenePicture& p : study.pictures)
        section.items.push_back(in_group(
            document::picture_of(stem + "-" + lower(p.name), p.name, shown(p.intensity)), "pictures"));
    for (const ScenePicture& p : study.pictures)
        section.items.push_back(
            in_group(document::picture_of(stem + "-" + lower(p.name) + "-difference",
                                          p.name + ": difference from Phong at Embree's hits",
                                          error_colours(in_float(p.difference), difference_scale)),
                     "differences"));
    return section;
}

}  // namespace zproof
