/// The parts that report.html is put together from. Every function returns markup that is already escaped.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "compare/verdict.h"
#include "reports/page_text.h"
#include "reports/results.h"

namespace zproof {

/// The style sheet: light and dark by the reader's preference, and for print.
std::string_view html_style();

/// One of a view's small pictures.
struct PagePicture {
    std::string name;       ///< "class": its files are class.png and class-small.png
    std::string caption;    ///< one sentence
    std::string data;       ///< data URI; empty where the picture is absent
    bool left_out = false;  ///< there is a picture, but the budget is spent
};

/// A view and what its section shows of it.
struct PageView {
    const ViewResult* view = nullptr;
    std::string anchor;  ///< fragment of its section
    std::vector<PagePicture> pictures;
};

/// The views, failed first, with pictures read from run_folder as far as the budget (bytes as text) goes.
std::vector<PageView> page_views(const Results& results, const std::filesystem::path& run_folder,
                                 std::size_t budget);

/// What the viewer reads, as elements of the page: the run, and of each view's planes.zvp as much as the
/// budget (bytes of the page) allows.
struct PagePlanes {
    Page elements;
    std::string omissions;  ///< a paragraph about what the page does not hold; empty where it holds all
};
PagePlanes page_planes(const std::vector<PageView>& pages, const std::filesystem::path& run_folder,
                       std::size_t budget);

/// The section of one view.
std::string html_view(const PageView& page);

/// The matrix of renderers; empty where nothing was judged.
std::string html_renderers(const Results& results);

/// What the oracles said of one view, and who agrees with whom; empty where none was asked.
std::string html_oracles(const ViewResult& view);

/// A coloured square with the class's glyph, then its name.
std::string class_badge(PixelClass c);

/// Glyph and word of an outcome.
std::string outcome_badge(Outcome outcome);

/// Error / bound as bars over a logarithmic count; the bound is the line at 1. `what` names it for those who
/// hear the page.
std::string histogram_svg(std::string_view what, const BoundRecord& record);

}  // namespace zproof
