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

PagePicture picture(const Kind& kind, const std::filesystem::path& folder, std::size_t budget) {
    PagePicture result{.name = kind.name, .caption = kind.caption, .data = {}};
    const std::string png = content_of(folder / (result.name + "-small.png"));
    if (png.empty()) return result;
    result.data = "data:image/png;base64," + base64(png);
    result.left_out = result.data.size() > budget;
    if (result.left_out) result.data.clear();
    return result;
}

}  // namespace

std::vector<PageView> page_views(const Results& results, const std::filesystem::path& run_folder,
                                 std::size_t budget) {
    std::vector<PageView> pages;
    for (const ViewResult* view : failed_first(results)) {
        PageView page{.view = view, .anchor = "view-" + std::to_string(pages.size() + 1), .pictures = {}};
        if (!view->folder.empty())
            for (const Kind& kind : kinds_of(*view)) {
                page.pictures.push_back(picture(kind, run_folder / view->folder, budget));
                budget -= page.pictures.back().data.size();
            }
        pages.push_back(std::move(page));
    }
    return pages;
}

}  // namespace zproof
