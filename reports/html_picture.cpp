#include <utility>

#include "frame/whole_file.h"
#include "reports/base64.h"
#include "reports/html.h"
#include "reports/html_parts.h"
#include "reports/wording.h"

namespace zproof {

namespace {

struct Kind {
    std::string name, caption;
};

/// Those of every view, then what a painting oracle adds.
std::vector<Kind> kinds_of(const ViewResult& view) {
    std::vector<Kind> kinds{{"class", "Verdict per pixel. Dark: both agree."},
                            {"id", "Candidate: a colour per triangle."},
                            {"reference-id", "Reference: a colour per triangle."},
                            {"depth", "Candidate: depth, near is bright. Magenta: no depth."},
                            {"colour", "Candidate: shaded by zproof, one light."}};
    for (const OracleResult& w : view.oracles)
        if (w.picture) {
            kinds.push_back(
                {w.name + "-colour", escaped(one_line(w.name)) + ": the same scene, camera and light."});
            kinds.push_back({w.name + "-difference",
                             escaped(one_line(w.name)) + ": difference in linear light. Dark: none."});
        }
    return kinds;
}

std::filesystem::path file_of(const PagePicture& picture, const std::filesystem::path& folder) {
    return folder / (picture.name + "-small.png");
}

std::vector<PagePicture> pictures_of(const ViewResult& view, const std::filesystem::path& folder) {
    std::vector<PagePicture> pictures;
    for (Kind& kind : kinds_of(view)) {
        pictures.push_back({.name = std::move(kind.name), .caption = std::move(kind.caption), .data = {}});
        pictures.back().left_out = std::filesystem::exists(file_of(pictures.back(), folder));
    }
    return pictures;
}

/// Reads the picture where it fits; returns its bytes in the page.
std::size_t take(PagePicture& picture, const std::filesystem::path& folder, std::size_t budget) {
    const std::string png = content_of(file_of(picture, folder));
    std::string data = png.empty() ? "" : "data:image/png;base64," + base64(png);
    picture.left_out = data.size() > budget;
    if (!picture.left_out) picture.data = std::move(data);
    return picture.data.size();
}

}  // namespace

std::vector<PageView> page_views(const Results& results, const std::filesystem::path& run_folder) {
    std::vector<PageView> pages;
    for (const ViewResult* view : failed_first(results)) {
        PageView page{.view = view, .anchor = "view-" + std::to_string(pages.size() + 1), .pictures = {}};
        if (const std::filesystem::path folder = run_folder / view->folder; !view->folder.empty()) {
            page.pictures = pictures_of(*view, folder);
            page.has_planes = std::filesystem::exists(folder / "planes.zvp");
        }
        pages.push_back(std::move(page));
    }
    return pages;
}

std::size_t take_pictures(std::span<PageView> views, const std::filesystem::path& run_folder,
                          std::size_t budget) {
    std::size_t taken = 0;
    for (PageView& page : views)
        for (PagePicture& picture : page.pictures)
            taken += take(picture, run_folder / page.view->folder, budget - taken);
    return taken;
}

}  // namespace zproof
