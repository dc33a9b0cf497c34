#include "cli/command_line/options.h"

namespace zproof {
namespace {

const std::map<std::string, ColourWish> colour_wishes{
    {"auto", ColourWish::automatic}, {"always", ColourWish::always}, {"never", ColourWish::never}};
const std::map<std::string, ProgressStyle> progress_styles{{"auto", ProgressStyle::automatic},
                                                           {"bar", ProgressStyle::bar},
                                                           {"lines", ProgressStyle::lines},
                                                           {"none", ProgressStyle::none}};

void add_detail(CLI::App& app, ReportArguments& report) {
    auto* quiet = app.add_flag_callback(
        "-q,--quiet",
        [&report] {
            report.detail = Detail::verdict;
            report.progress = ProgressStyle::none;
        },
        "print the verdict only");
    app.add_flag_callback(
           "--times", [&report] { report.detail = Detail::times; }, "also print where the time went")
        ->excludes(quiet);
}

}  // namespace

void add_threads(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "the verdict is the same for any number")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
}

void add_render_settings(CLI::App& app, RenderSettings& settings) {
    app.add_option("--width", settings.resolution.width, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    app.add_option("--height", settings.resolution.height, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    add_threads(app, settings.threads);
}

void add_report(CLI::App& app, ReportArguments& report) {
    app.add_option("-o,--out", report.out, "folder for the reports")->capture_default_str();
    add_choice(app, "--color", report.colour, colour_wishes)
        ->description("of the table on the terminal; auto: unless NO_COLOR is set");
    add_choice(app, "--progress", report.progress, progress_styles)
        ->description("how it is told on stderr; auto: a bar on a terminal, else a line per view");
    app.add_flag_callback(
        "--pictures", [&report] { report.pictures = PictureWish::shaded; },
        "shaded colour pictures, beside those of witnesses that can paint");
    add_detail(app, report);
}

}  // namespace zproof
