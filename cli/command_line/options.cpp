#include "cli/command_line/options.h"

#include "cli/samples.h"
#include "cli/usage_error.h"
#include "math/processor.h"

namespace zproof {
namespace {

const std::map<std::string, ColourMode> colour_modes{
    {"auto", ColourMode::automatic}, {"always", ColourMode::always}, {"never", ColourMode::never}};
const std::map<std::string, ProgressStyle> progress_styles{{"auto", ProgressStyle::automatic},
                                                           {"bar", ProgressStyle::bar},
                                                           {"lines", ProgressStyle::lines},
                                                           {"none", ProgressStyle::none}};
const std::map<std::string, Evidence> evidences{{"all", Evidence::all}, {"defects", Evidence::defects}};

void add_detail(CLI::App& app, ReportArguments& report) {
    auto* quiet = app.add_flag_callback(
        "-q,--quiet", [&report] { report.detail = Detail::verdict; }, "print the verdict only");
    app.add_flag_callback(
           "--times", [&report] { report.detail = Detail::times; }, "also print where the time went")
        ->excludes(quiet);
}

}  // namespace

void add_models(CLI::App& app, std::filesystem::path& models) {
    app.add_option("--models", models, "folder beneath which the models of view files may lie")
        ->check(CLI::ExistingDirectory);
}

void add_threads(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "the verdict is the same for any number")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
}

void add_isa(CLI::App& app) {
    app.add_option_function<std::string>(
           "--isa",
           [](const std::string& word) {
               try {
                   allow_at_most(instruction_set_from(word));
               } catch (const InstructionSetError& e) {
                   throw UsageError{std::string{"--isa: "} + e.what()};
               }
           },
           "the widest instruction set of zproof's own code, scalar, avx2 or avx512; no bit depends on it")
        ->default_str("all that the processor has");
}

void add_render_settings(CLI::App& app, RenderSettings& settings) {
    app.add_option("--width", settings.resolution.width, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    app.add_option("--height", settings.resolution.height, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    add_threads(app, settings.threads);
    add_isa(app);
}

void add_samples(CLI::App& app, RenderSettings& settings) {
    app.add_option_function<std::string>(
        "--sample", [&settings](const std::string& word) { settings.samples = samples_from_word(word); },
        "where pixels are sampled: DX,DY from their centres, standard:COUNT (each sample of that pattern), "
        "or "
        "standard:COUNT:INDEX");
}

void add_report(CLI::App& app, ReportArguments& report) {
    app.add_option("-o,--out", report.out, "folder for the reports")->capture_default_str();
    app.add_option_function<std::vector<std::string>>(
           "--report",
           [&report](const std::vector<std::string>& words) {
               report.formats.clear();
               for (const std::string& word : words) report.formats.push_back(format_from(word));
           },
           "html, json, junit, md, github, csv; results.json is always written")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->default_str("html,json,junit");
    add_choice(app, "--color", report.colour, colour_modes)
        ->description("of the table on the terminal; auto: unless NO_COLOR is set");
    add_choice(app, "--progress", report.progress, progress_styles)
        ->description("how it is told on stderr; auto: a bar on a terminal, else a line per view");
    add_detail(app, report);
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

void add_settings_choice(CLI::App& app, SettingsChoice& settings) {
    app.add_option("--config", settings.file, "settings file; default: zproof.toml, where it is; or none");
    app.add_option("--profile", settings.profile, "the table [profiles.NAME] of the settings file");
}

ReportArguments understood(ReportArguments report) {
    if (report.detail == Detail::verdict) report.progress = ProgressStyle::none;
    return report;
}

}  // namespace zproof
