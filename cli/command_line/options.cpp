#include "cli/command_line/options.h"

#include "program/samples.h"
#include "program/usage_error.h"
#include "scenes/random_scenes.h"

namespace zproof {
namespace {

const std::map<std::string, Evidence> evidences{{"all", Evidence::all}, {"defects", Evidence::defects}};

/// Gives the height of "640x480" to that option, as if it had been typed, and leaves the width. CLI11 reads
/// the options in the order in which they were added: the height after the width.
std::string hand_on_height(std::string& width, CLI::Option& height) {
    const std::size_t times = width.find('x');
    if (times == std::string::npos) return "";
    height.add_result(width.substr(times + 1));
    width.erase(times);
    return "";
}

}  // namespace

std::array<CLI::Option*, 2> add_random_choice(CLI::App& app, RandomChoice& random) {
    std::vector<std::string> names{std::string(any_random_kind)};
    for (const RandomKind& kind : random_kinds()) names.emplace_back(kind.name);
    auto* seed = app.add_option("--seed", random.seed, "of the random scenes")->capture_default_str();
    auto* kind = app.add_option("--kind", random.kind, "of the random scenes; any: each in turn")
                     ->check(CLI::IsMember(names))
                     ->capture_default_str();
    return {seed, kind};
}

void add_models(CLI::App& app, std::filesystem::path& models) {
    app.add_option("--models", models, "folder beneath which the models of view files may lie")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
}

void add_render_settings(CLI::App& app, RenderSettings& settings) {
    auto* width = app.add_option("--width", settings.resolution.width,
                                 "pixels, or both sides as 640x480; view files state their own");
    auto* height =
        app.add_option("--height", settings.resolution.height, "pixels; view files state their own");
    width->transform(
        CLI::Validator([height](std::string& word) { return hand_on_height(word, *height); }, ""));
    for (CLI::Option* side : {width, height}) side->check(CLI::Range(1, 32768))->capture_default_str();
    add_isa(app);
}

void add_samples(CLI::App& app, RenderSettings& settings) {
    app.add_option_function<std::string>(
           "--sample",
           [&settings](const std::string& word) {
               settings.samples = samples_from_word(word);
               settings.sample_word = word;
           },
           "where pixels are sampled: DX,DY from their centres, standard:COUNT (each sample of that "
           "pattern), "
           "or standard:COUNT:INDEX")
        ->type_name("SAMPLE");
}

void add_report(CLI::App& app, ReportArguments& report) {
    add_common(app, report.common, "folder for the reports");
    add_progress(app, report.common);
    app.add_flag_callback(
           "--wide", [&report] { report.columns = ReportArguments::Columns::all; },
           "the table of views with all its columns, however wide the terminal is")
        ->group(machine_options);
    app.add_flag_callback(
           "--times", [&report] { report.common.detail = Detail::times; }, "also print where the time went")
        ->group(machine_options)
        ->excludes(app.get_option("--quiet"));
    app.add_option_function<std::vector<std::string>>(
           "--report",
           [&report](const std::vector<std::string>& words) {
               report.formats.clear();
               for (const std::string& word : words) report.formats.push_back(format_from(word));
           },
           "html, json, junit, md, github, csv; results.json is always written")
        ->type_name("FORMATS")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->default_str("html,json,junit")
        ->group(machine_options);
}

void add_evidence(CLI::App& app, ReportArguments& report) {
    add_choice(app, "--evidence", report.evidence, evidences)
        ->default_str(report.evidence == Evidence::all ? "all" : "defects")
        ->description(
            "frames, pictures, findings and the viewer's planes: of all views, or of those with defects "
            "only");
    app.add_flag_callback(
        "--pictures", [&report] { report.pictures = PictureMode::shaded; },
        "shaded colour pictures, beside those of oracles that can paint");
    app.add_flag_callback(
        "--no-diagnosis", [&report] { report.diagnosis = CauseSearch::left_out; },
        "seek no causes: faster where views fail");
}

void add_waiver_file(CLI::App& app, GateArguments& gate) {
    app.add_option("--waivers", gate.waivers, "file of waivers (.toml)");
    app.add_option_function<std::string>(
        "--now",
        [&gate](const std::string& word) {
            gate.today = day_from(word);
            if (!gate.today)
                throw UsageError{"--now: expected a day such as 2026-04-10, found '" + word + "'"};
        },
        "the day that waivers are held against; default: today, UTC");
}

void add_gate(CLI::App& app, GateArguments& gate) {
    add_waiver_file(app, gate);
    app.add_flag_callback(
        "--strict", [&gate] { gate.strictness = Strictness::strict; },
        "waivers that are not needed, or allow too much, fail as well");
}

void add_reference_cache(CLI::App& app, oracle::ReferenceCacheChoice& choice) {
    auto* folder = app.add_option("--reference-cache", choice.folder,
                                  "folder where Embree's frames are kept for other runs; many may share it")
                       ->type_name("FOLDER")
                       ->group(machine_options);
    app.add_option("--reference-cache-size", choice.most_bytes,
                   "the most that it may hold, such as 500MB; what was not used the longest goes")
        ->transform(CLI::AsSizeValue(false))
        ->default_str("10GB")
        ->group(machine_options)
        ->needs(folder);
}

void add_settings_choice(CLI::App& app, SettingsChoice& settings) {
    app.add_option("--config", settings.file, "settings file; default: zproof.toml, where it is; or none")
        ->group(machine_options);
    app.add_option("--profile", settings.profile, "the table [profiles.NAME] of the settings file")
        ->group(machine_options);
}

}  // namespace zproof
