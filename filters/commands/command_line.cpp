#include "filters/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "filters/commands/commands.h"
#include "filters/commands/precision_words.h"
#include "filters/methods/catalogue.h"
#include "filters/study/published_results.h"
#include "frame/joined.h"
#include "program/command_line/common_options.h"
#include "program/command_line/companion_tree.h"
#include "program/command_line/parsing.h"
#include "program/samples.h"
#include "program/shell_line.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr const char* check_remark = R"(
What may be promised, each by default as exactly as zproof's own filters: arithmetic_bits, coordinate_bits,
displacement_px, step_bits, place_bits, weight_bits, split_bits, lod_bits, lod_below, lod_above, tap_bits,
sum_bits, texel_bits, colour_bits (docs/filter-conformance.md); lod_slack=1 is lod_below=0.5,lod_above=1,
what Vulkan admits. output=srgb8: a picture of 8-bit sRGB codes, each the nearest one (code_error=0.5).
A preset may come first: gpu, d3d11, vulkan-min, float32, float64, oiio. So --precision gpu,lod_bits=6 is a
GPU with 6 bits of LOD (docs/joint-conformance.md).

Exit status: 0 every picture keeps to its definition, 1 one does not, 3 of one nothing is proved: a picture
off by half a texel or level would pass as well.)";

/// Defaults are shown where there are any.
template <class Size>
void add_size(CLI::App& app, Size& width, Size& height) {
    app.add_option("--width", width, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    app.add_option("--height", height, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
}

void add_truth(CLI::App& app, std::string& letters) {
    std::vector<std::string> known;
    for (const oracle::NamedReconstruction& named : oracle::reconstructions)
        known.emplace_back(named.letters);
    app.add_option(
           "--truth", letters,
           "N: of nearest texels; B: of bilinear; G: Gaussian pixel of bilinear; GN: the same of nearest; "
           "M: Mitchell's pixel of bilinear; BH: Blackman and Harris's")
        ->check(CLI::IsMember(known))
        ->capture_default_str();
}

void add_precision(CLI::App& app, std::string& words) {
    app.add_option("--precision", words, "what the filter promises, as PRESET,key=value,key=value")
        ->type_name("PROMISE");
}

void add_run(CLI::App& app, FiltersWords& words) {
    app.add_option("SCENE", words.run.scenes,
                   "filter scene (zproof filters list), suite scene, model (.gltf, .glb, .obj, .ply) or view "
                   "file, or a photograph "
                   "(.png, .jpg; .exr, .dds); none: every filter scene");
    app.add_option("--methods", words.methods,
                   "all of zproof's own, and names with settings, separated by commas")
        ->type_name("METHODS")
        ->capture_default_str();
    app.add_option(
           "--picture", words.pictures,
           "NAME=FILE or NAME='COMMAND {scene} {camera} {out}': a picture of another renderer beside the "
           "methods; in FILE, {scene} and {view} stand for their names; repeatable")
        ->take_all()
        ->allow_extra_args(false);
    app.add_option(
           "--claim", words.claims.claims,
           "NAME=METHOD: the picture of that name is of this method of zproof's; the viewer shows what "
           "the method permits; repeatable")
        ->take_all()
        ->allow_extra_args(false);
    add_precision(app, words.claims.promise);
    add_truth(app, words.truth);
    app.add_option("--flicker", words.run.flicker_steps,
                   "further views, each a fraction of a pixel on; 0: none")
        ->check(CLI::Range(0, 32))
        ->capture_default_str();
    add_common(app, words.run.common, "folder for the study");
    add_progress(app, words.run.common);
    app.add_flag("--evidence", words.run.writes_evidence,
                 "error, FLIP, certainty, footprint and region of every pixel as OpenEXR files, too");
    app.add_option(
           "--inspect", words.inspected,
           "X,Y,WIDTH,HEIGHT: what methods read at every pixel of this box, in the viewer; default: at "
           "the worst pixels")
        ->type_name("CROP");
    app.add_option("--view", words.views, "names of views, separated by commas; default: all of every scene")
        ->type_name("VIEW");
    app.add_option("--first-row", words.run.first_row,
                   "rows above count in the regions all and horizon only; default 0, of 'worked' 56 of 256")
        ->check(CLI::Range(0, 32767));
    add_size(app, words.run.width, words.run.height);
    add_isa(app);
    app.footer("\nSettings of a method, NAME:key=value:key=value:\n" + filter_settings_help());
}

void add_table(CLI::App& app, FiltersWords& words) {
    app.add_option("DIR", words.table.folder, "what 'filters run' wrote")->type_name("FOLDER")->required();
    add_common(app, words.table.common);
    app.add_option("--region", words.table.choice.region,
                   "such as all, silhouette, magnified, 'anisotropy 8-16'")
        ->type_name("REGION")
        ->capture_default_str();
    app.add_option("--columns", words.table_columns,
                   "metrics, flicker and costs to show, separated by commas; default: all");
    app.add_option("--sort", words.table.choice.sort, "a column, the best first; default: the study's order");
    app.add_flag("--pooled", words.table.is_pooled,
                 "all textures together: means and ranks with 95 % intervals; a table for each metric");
    app.add_option("--baseline", words.table.baseline,
                   "the method that --pooled compares the others with; default: the best");
    auto* latex = app.add_flag_callback(
        "--latex", [&words] { words.table.format = TableFormat::latex; }, "LaTeX with booktabs");
    app.add_flag_callback(
           "--csv", [&words] { words.table.format = TableFormat::csv; }, "every value, a row each")
        ->excludes(latex);
}

void add_figure(CLI::App& app, FiltersWords& words) {
    app.add_option("DIR", words.figure.folder, "what 'filters run' wrote")->type_name("FOLDER")->required();
    add_common(app, words.figure.common, "folder for plots, crops and page; default: DIR");
    app.add_option("--methods", words.only, "those to name in colour, separated by commas; default: the best")
        ->type_name("METHODS");
    app.add_option("--crop", words.crop, "X,Y,WIDTH,HEIGHT in pixels; default: where methods err most")
        ->type_name("CROP");
}

void add_check(CLI::App& app, FiltersWords& words) {
    app.add_option("METHODS", words.check_methods, "all, or names with settings, separated by commas")
        ->required();
    app.add_option("SCENE", words.check.scenes, "as of 'filters run'; none: every filter scene");
    app.add_option("--view", words.check_views,
                   "names of views, separated by commas; default: all of every scene")
        ->type_name("VIEW");
    app.add_option("--picture", words.check.picture, "judge this picture (.exr) of one method and one view");
    add_precision(app, words.precision);
    app.add_flag_callback(
        "--json", [&words] { words.check.format = CheckFormat::json; }, "for programs");
    add_size(app, words.check.width, words.check.height);
    add_common(app, words.check.common);
    add_isa(app);
    app.footer(check_remark);
}

void add_normals(CLI::App& app, FiltersWords& words) {
    FiltersNormalsArguments& normals = words.normals;
    app.add_option("MAP", normals.map, "normals of tangent space as an image (.png, .jpg, .dds); none: bumps")
        ->type_name("FILE");
    app.add_option("--methods", words.normal_methods, "filters of the map, separated by commas")
        ->type_name("METHODS")
        ->capture_default_str();
    app.add_option("--view", words.normal_views, "names of views, separated by commas; default: all")
        ->type_name("VIEW");
    app.add_option("--shininess", normals.light.shininess, "the exponent s of (n . h)^s")
        ->check(CLI::Range(1.0, 65536.0))
        ->capture_default_str();
    app.add_option("--half-angle", words.half_angle, "degrees by which h leans along u")
        ->check(CLI::Range(-80.0, 80.0))
        ->capture_default_str();
    add_size(app, normals.resolution.width, normals.resolution.height);
    add_common(app, normals.common);
    add_isa(app);
}

void add_filtered(CLI::App& app, FiltersWords& words) {
    app.group("");  // hidden
    app.add_option("SCENE", words.filtered.scene)->required();
    app.add_option("--models", words.filtered.models);
    app.add_option("--filter", words.filter)->required();
    app.add_option("--sample", words.sample);
    app.add_option("--frames", words.filtered.frames, "folder of VIEW.exr; none: the words are only checked");
    add_size(app, words.filtered.resolution.width, words.filtered.resolution.height);
    add_common(app, words.filtered.common);
}

std::vector<std::string> words_of_list(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream in{text};
    for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
    return parts;
}

/// So many whole numbers, separated by commas, from `least` to 32768; none where the text is something else.
template <std::size_t count>
std::optional<std::array<int, count>> whole_numbers(const std::string& text,
                                                    const std::array<int, count>& least) {
    std::array<int, count> numbers{};
    const std::vector<std::string> parts = words_of_list(text);
    bool is_right = parts.size() == count;
    for (std::size_t i = 0; is_right && i < count; ++i) {
        const char* const end = parts[i].data() + parts[i].size();
        const auto [stop, error] = std::from_chars(parts[i].data(), end, numbers[i]);
        is_right = error == std::errc{} && stop == end && numbers[i] >= least[i] && numbers[i] <= 32768;
    }
    return is_right ? std::optional{numbers} : std::nullopt;
}

CropBox crop_box(const std::string& option, const std::string& text) {
    const auto numbers = whole_numbers<4>(text, {0, 0, 1, 1});
    if (!numbers) throw UsageError{option + ": expected X,Y,WIDTH,HEIGHT in pixels, found '" + text + "'"};
    const auto [x, y, width, height] = *numbers;
    return {x, y, width, height};
}

PixelCoord pixel_coord(const std::string& text) {
    const auto numbers = whole_numbers<2>(text, {0, 0});
    if (!numbers) throw UsageError{"--pixel: expected X,Y, found '" + text + "'"};
    return {(*numbers)[0], (*numbers)[1]};
}

void add_explain(CLI::App& app, FiltersWords& words) {
    FiltersExplainArguments& explain = words.explain;
    app.add_option("SCENE", explain.scene, "as of 'filters run'")->required();
    app.add_option("--view", explain.view, "name of a view")->type_name("VIEW")->required();
    app.add_option("--pixel", words.explained_pixel, "X,Y from the upper left corner")
        ->type_name("PIXEL")
        ->required();
    app.add_option("--methods,--method", words.explained_methods, "names with settings, separated by commas")
        ->type_name("METHODS")
        ->required();
    app.add_option("--picture", explain.picture,
                   "what this picture (.exr) has there, beside what the one method permits");
    add_precision(app, words.explained_promise);
    add_truth(app, words.explained_truth);
    add_size(app, explain.width, explain.height);
    add_common(app, explain.common);
    app.footer("\nExit status: 0 the pixel is explained, and the picture's value is permitted; 1 it is not.");
}

}  // namespace

std::vector<FilterChoice> filter_choices(const std::string& words,
                                         FilterChoice (*choice)(const std::string&)) {
    std::vector<FilterChoice> choices;
    const auto add = [&](const std::string& word) {
        if (std::ranges::find(choices, word, &FilterChoice::typed) == choices.end())
            choices.push_back(choice(word));
    };
    for (const std::string& word : words_of_list(words)) {
        if (word != "all")
            add(word);
        else
            for (const texture::Method& method : texture::methods()) add(method.name);
    }
    if (choices.empty()) throw UsageError{"--methods: expected 'all' or names (zproof filters list)"};
    return choices;
}

namespace {

std::optional<FilterPrecision> chosen_precision(const std::string& words) {
    if (words.empty()) return {};
    return filter_precision_from_words(words_of_list(words));
}

FiltersExplainArguments chosen_explain(FiltersWords& words) {
    FiltersExplainArguments& explain = words.explain;
    explain.pixel = pixel_coord(words.explained_pixel);
    explain.methods = filter_choices(words.explained_methods, study_choice);
    explain.truth = *oracle::reconstruction_of(words.explained_truth);
    const std::optional<FilterPrecision> promise = chosen_precision(words.explained_promise);
    if (explain.picture.empty()) {
        if (promise) throw UsageError{"--precision: expected together with --picture"};
        return explain;
    }
    if (explain.methods.size() != 1) throw UsageError{"--picture: one method is expected"};
    const FilterChoice& method = explain.methods.front();
    explain.claim = {method, words.explained_promise, claim_of(method, promise)};
    return explain;
}

FiltersFilteredArguments chosen_filtered(FiltersWords& words) {
    words.filtered.filter = filter_choice(words.filter);
    if (!words.sample.empty()) words.filtered.samples = samples_from_word(words.sample);
    return words.filtered;
}

FiltersTableArguments chosen_table(FiltersWords& words) {
    words.table.choice.columns = words_of_list(words.table_columns);
    if (!words.table.baseline.empty() && !words.table.is_pooled)
        throw UsageError{"--baseline: expected together with --pooled"};
    if (!words.table.choice.sort.empty() && words.table.is_pooled)
        throw UsageError{"--sort: --pooled puts the best first by itself"};
    return words.table;
}

FiltersCheckArguments chosen_check(FiltersWords& words) {
    FiltersCheckArguments& check = words.check;
    check.methods = filter_choices(words.check_methods, filter_choice);
    check.views = words_of_list(words.check_views);
    check.precision = chosen_precision(words.precision);
    if (!check.picture.empty() && check.methods.size() != 1)
        throw UsageError{"--picture: one method is expected, and one view"};
    return check;
}

FiltersNormalsArguments chosen_normals(FiltersWords& words) {
    words.normals.methods = filter_choices(words.normal_methods, filter_choice);
    words.normals.views = words_of_list(words.normal_views);
    const double angle = glm::radians(words.half_angle);
    words.normals.light.half = {std::sin(angle), 0, std::cos(angle)};
    return words.normals;
}

std::vector<PictureChoice> chosen_pictures(const FiltersWords& words) {
    std::vector<PictureChoice> pictures;
    for (const std::string& word : words.pictures) pictures.push_back(picture_choice(word));
    std::vector<std::string> methods;
    for (const FilterChoice& method : words.run.methods) methods.push_back(method.typed);
    refuse_equal_names(pictures, methods);
    ClaimWords claims = words.claims;
    claims.precision = chosen_precision(claims.promise);
    add_claims(pictures, claims);
    return pictures;
}

/// Both must outlive the parsing.
void add_commands(CLI::App& app, FiltersWords& words) {
    add_run(*app.add_subcommand("run", "hold methods to the truth on scenes; write a study"), words);
    add_common(*app.add_subcommand("list", "methods, metrics and scenes, a line each"), words.list.common);
    CLI::App& scenes = *app.add_subcommand("scenes", "write filter scenes as .glb and .view.json files");
    scenes.add_option("NAME", words.scenes.names, "of filter scenes; none: all");
    add_common(scenes, words.scenes.common, "folder for the files");
    CLI::App& reproduce =
        *app.add_subcommand("reproduce", "published results, computed again beside the published figures");
    reproduce.add_option(
        "NAME", words.reproduce.names,
        joined(study::published_results(), ", ", &study::PublishedResult::name) + "; none: all");
    add_common(reproduce, words.reproduce.common);
    add_table(*app.add_subcommand("table", "print a study's table"), words);
    add_figure(*app.add_subcommand("figure", "make a study's plots, crops and page again"), words);
    add_check(*app.add_subcommand("check", "does a filter compute its own definition? pixel by pixel"),
              words);
    add_explain(*app.add_subcommand("explain", "what methods read at one pixel, and why they are off"),
                words);
    CLI::App& crow =
        *app.add_subcommand("crow", "Crow 1984: the lecture's figure and its questions, answered");
    add_common(crow, words.crow.common, "folder for the page");
    add_size(crow, words.crow.settings.resolution.width, words.crow.settings.resolution.height);
    add_isa(crow);
    add_normals(
        *app.add_subcommand("normals", "highlights of filtered normal maps, held to their exact mean"),
        words);
    add_common(*app.add_subcommand("selftest", "plant known faults in filters; are they caught?"),
               words.selftest.common);
    add_filtered(*app.add_subcommand("filtered", "what zproof render asks for --filter"), words);
}

/// The command that was typed, its words understood. Throws UsageError where none was, or a word means
/// nothing.
Command chosen_command(const CLI::App& app, FiltersWords& words) {
    const auto typed = [&](const char* name) { return app.get_subcommand(name)->parsed(); };
    if (typed("run")) {
        words.run.methods = filter_choices(words.methods, study_choice);
        words.run.pictures = chosen_pictures(words);
        words.run.truth = *oracle::reconstruction_of(words.truth);
        words.run.views = words_of_list(words.views);
        if (!words.inspected.empty()) words.run.inspected = crop_box("--inspect", words.inspected);
        return command_of(words.run, "cannot study the filters");
    }
    if (typed("list")) return command_of(words.list, "cannot list the filters");
    if (typed("scenes")) return command_of(words.scenes, "cannot write the scenes");
    if (typed("reproduce")) return command_of(words.reproduce, "cannot reproduce");
    if (typed("check")) return command_of(chosen_check(words), "cannot judge");
    if (typed("explain")) return command_of(chosen_explain(words), "cannot explain");
    if (typed("table")) return command_of(chosen_table(words), "cannot show the table");
    if (typed("selftest")) return command_of(words.selftest, "cannot test the filters' judge");
    if (typed("filtered")) return command_of(chosen_filtered(words), "cannot filter");
    if (typed("crow")) return command_of(words.crow, "cannot make the page");
    if (typed("normals")) return command_of(chosen_normals(words), "cannot shade the normals");
    if (!typed("figure"))
        throw UsageError{
            "filters: 'run', 'list', 'scenes', 'reproduce', 'table', 'figure', 'check', 'explain', 'normals' "
            "or "
            "'crow' expected "
            "(see: zproof filters --help)"};
    words.figure.labels = words_of_list(words.only);
    if (!words.crop.empty()) words.figure.crop = crop_box("--crop", words.crop);
    return command_of(words.figure, "cannot draw the figures");
}

}  // namespace

Command parse_filters(int argc, const char* const* argv, const Environment& environment) {
    FiltersWords words;
    std::vector<std::string> typed{argv + 1, argv + argc};
    typed.insert(typed.begin(), "filters");
    words.run.typed = shell_line(typed);
    CompanionTree tree{"filters", filters_program::examples(), filters_program::value_kinds()};
    add_commands(tree.root(), words);
    if (auto answer = tree.answer(argc, argv)) return *answer;
    take_settings(tree.root(), {}, environment);
    return chosen_command(tree.root(), words);
}

}  // namespace zproof
