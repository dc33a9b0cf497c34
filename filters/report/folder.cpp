#include "filters/report/folder.h"

#include <span>

#include "filters/report/json.h"
#include "filters/report/page.h"
#include "filters/report/plots.h"
#include "filters/report/pooled.h"
#include "filters/report/tables.h"
#include "frame/number_text.h"
#include "frame/whole_file.h"
#include "image_io/image_io.h"
#include "reports/page_parts.h"
#include "reports/pictures.h"
#include "reports/result_file.h"

namespace zproof {

namespace {

namespace fs = std::filesystem;
using namespace study;

void write_text(const fs::path& file, const std::string& text) {
    write_whole_file(file, std::as_bytes(std::span{text}));
}

CropBox crop_of(const fs::path& folder, const ViewStudy& view, const Picture& truth,
                const FigureChoice& choice) {
    if (choice.crop) {
        if (const auto box = within(*choice.crop, truth.size())) return *box;
        throw ReportError{"crop " + in_words(*choice.crop) + " lies outside " + view.scene + " / " +
                          view.view + ", which is " + size_text(view.width, view.height)};
    }
    ErrorTally tally{truth};
    for (const MethodScore& method : view.methods) tally.add(read_picture(folder / method.file));
    return tally.worst(crop_side);
}

std::string study_view_name(const ViewStudy& view) { return view_folder(view).filename().string(); }

/// Writes the piece magnified, and gives it to the page as it is.
PageImage write_crop(const fs::path& file, const Picture& picture, const CropBox& box,
                     const std::string& caption) {
    write_png(file, crop(picture, box, crop_magnification));
    return {caption, png_uri(crop(picture, box, 1))};
}

/// A method's piece and its error.
PageImage write_method_crop(const fs::path& crops, const Picture& picture, const Picture& truth,
                            const CropBox& box, const std::string& label) {
    PageImage image = write_crop(crops / (file_stem(label) + ".png"), picture, box, label);
    write_png(crops / (file_stem(label) + "-error.png"), error_crop(picture, truth, box, crop_magnification));
    image.error = png_uri(error_crop(picture, truth, box, 1));
    return image;
}

ViewFigures figures_of(const FigureFolders& folders, const StudyResults& results, const ViewStudy& view,
                       const FigureChoice& choice) {
    const fs::path &folder = folders.study, crops = folders.figures / "crops" / study_view_name(view),
                   plots = folders.figures / "plots" / study_view_name(view);
    const Picture truth = read_picture(folder / view.truth_file);
    fs::create_directories(crops);
    fs::create_directories(plots);
    const Plane<Rgb8> whole = picture_of_light(truth);
    ViewFigures figures{.truth = {"The truth.", png_uri(thinned(whole, shrink_factor(whole.size())))},
                        .crop = crop_of(folder, view, truth, choice),
                        .crops = {},
                        .plots = filters_plots(results, view, choice.labels)};
    figures.crops.push_back(write_crop(crops / "truth.png", truth, figures.crop, "truth"));
    for (const MethodScore& method : view.methods)
        figures.crops.push_back(
            write_method_crop(crops, read_picture(folder / method.file), truth, figures.crop, method.label));
    for (const Plot& plot : figures.plots) write_text(plots / (plot.name + ".svg"), plot.svg);
    return figures;
}

}  // namespace

void write_filters_results(const fs::path& folder, const StudyResults& results) {
    write_text(folder / "filters.json", filters_json(results));
    write_text(folder / "filters.csv", filters_csv(results));
    if (texture_count(results) > 1) write_text(folder / "pooled.csv", pooled_csv(results, "interior"));
    write_text(folder / "table.tex", filters_latex(results, {"interior"}));
}

void write_filters_figures(const FigureFolders& folders, const StudyResults& results,
                           const FigureChoice& choice) {
    StudyFigures figures;
    for (const ViewStudy& view : results.views)
        figures.views.push_back(figures_of(folders, results, view, choice));
    if (results.views.size() > 1) figures.overview = filters_plots(results, choice.labels);
    if (texture_count(results) > 1) figures.pools = page_pools(results);
    for (const PooledScores& pool : figures.pools) figures.overview.push_back(pooled_plot(results, pool));
    for (const Plot& plot : figures.overview)
        write_text(folders.figures / "plots" / (plot.name + ".svg"), plot.svg);
    const StudyPage page = filters_page(results, figures, folders.study);
    if (!page.scripts.empty()) fs::create_directory(folders.figures / "planes");
    for (const planes::ScriptFile& script : page.scripts)
        write_page(folders.figures / script.name, script.text);
    write_page(folders.figures / "filters.html", page.page);
}

StudyResults read_filters_results(const fs::path& folder) {
    const std::string text = read_result(folder / "filters.json", "a folder that 'zproof filters run' wrote");
    try {
        return filters_from_json(text);
    } catch (const ReportError& e) {
        throw ReportError{(folder / e.what()).string()};
    }
}

std::string file_stem(const std::string& label) {
    std::string stem;
    for (const char c : label) {
        const bool is_safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                             c == '-' || c == '.';
        stem += is_safe ? c : '_';
    }
    return stem;
}

}  // namespace zproof
