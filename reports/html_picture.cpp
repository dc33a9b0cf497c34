#include <utility>

#include "frame/whole_file.h"
#include "reports/base64.h"
#include "reports/html.h"
#include "reports/html_parts.h"
#include "reports/pictures.h"
#include "reports/wording.h"

namespace zproof {

namespace {

/// Its files are NAME.png and NAME-small.png.
PagePicture shrunk_picture(const std::string& name, std::string caption) {
    return {name, name + ".png", name + "-small.png", std::move(caption), {}};
}

std::string caption_of_classes(const ViewResult& view) {
    const bool dotted = has_dots({view.width, view.height});
    return std::string("Verdict per pixel. Dark: both agree.") +
           (dotted ? " A defect is drawn 3 pixels wide." : "");
}

/// Those of every view, then what a painting oracle adds.
std::vector<PagePicture> kinds_of(const ViewResult& view) {
    std::vector<PagePicture> kinds{
        {"view",
         "view-large.jpg",
         "view-large.jpg",
         "What the candidate saw, shaded by zproof. Rings: pixels that differ, in the colour of their class.",
         {}},
        shrunk_picture("class", caption_of_classes(view)),
        shrunk_picture("id", "Candidate: a colour per triangle."),
        shrunk_picture("reference-id", "Reference: a colour per triangle."),
        shrunk_picture("depth", "Candidate: depth, near is bright. Magenta: no depth."),
        shrunk_picture("colour", "Candidate: shaded by zproof, one light.")};
    for (const OracleResult& w : view.oracles)
        if (w.picture) {
            const std::string name = escaped(one_line(w.name));
            kinds.push_back(shrunk_picture(w.name + "-colour", name + ": the same scene, camera and light."));
            kinds.push_back(
                shrunk_picture(w.name + "-difference", name + ": difference in linear light. Dark: none."));
        }
    return kinds;
}

std::vector<PagePicture> pictures_of(const ViewResult& view, const std::filesystem::path& folder) {
    std::vector<PagePicture> pictures = kinds_of(view);
    for (PagePicture& picture : pictures) picture.left_out = std::filesystem::exists(folder / picture.shown);
    return pictures;
}

/// The file as a data URI; empty where there is none.
std::string data_uri(const std::filesystem::path& file) {
    const std::string bytes = content_of(file), end = file.extension().string();
    const std::string kind = end == ".jpg" ? "jpeg" : end.substr(1);
    return bytes.empty() ? "" : "data:image/" + kind + ";base64," + base64(bytes);
}

/// Reads the picture where it fits; returns its bytes in the page.
std::size_t take(PagePicture& picture, const std::filesystem::path& folder, std::size_t budget) {
    std::string data = data_uri(folder / picture.shown);
    picture.left_out = data.size() > budget;
    if (!picture.left_out) picture.data = std::move(data);
    return picture.data.size();
}

}  // namespace

std::vector<PageView> page_views(const Results& results, const std::filesystem::path& run_folder) {
    std::vector<PageView> pages;
    for (const ViewResult* view : failed_first(results)) {
        PageView page{.view = view,
                      .anchor = "view-" + std::to_string(pages.size() + 1),
                      .picture = {},
                      .pictures = {}};
        if (const std::filesystem::path folder = run_folder / view->folder; !view->folder.empty()) {
            page.pictures = pictures_of(*view, folder);
            page.has_planes = std::filesystem::exists(folder / "planes.zvp");
        }
        pages.push_back(std::move(page));
    }
    return pages;
}

std::string card_picture_of(const ViewResult& view, const std::filesystem::path& run_folder) {
    return view.folder.empty() ? "" : data_uri(run_folder / view.folder / "view.webp");
}

std::size_t take_pictures(std::span<PageView> views, const std::filesystem::path& run_folder,
                          std::size_t budget) {
    std::size_t taken = 0;
    for (PageView& page : views) {
        page.picture = card_picture_of(*page.view, run_folder);
        if (taken + page.picture.size() > budget) page.picture.clear();
        taken += page.picture.size();
    }
    for (PageView& page : views)
        for (PagePicture& picture : page.pictures)
            taken += take(picture, run_folder / page.view->folder, budget - taken);
    return taken;
}

}  // namespace zproof
