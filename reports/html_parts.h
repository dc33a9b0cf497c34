/// The parts that report.html is put together from. Every function returns markup that is already escaped.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/verdict.h"
#include "reports/page_text.h"
#include "reports/results.h"

namespace zproof {

/// The style sheet: light and dark by the reader's preference, and for print.
std::string_view html_style();

/// One of a view's pictures.
struct PagePicture {
    std::string name;       ///< "class"
    std::string file;       ///< in the view's folder, that a click opens: "class.png"
    std::string shown;      ///< in the view's folder, that the page holds: "class-small.png"
    std::string caption;    ///< one sentence
    std::string data;       ///< data URI; empty where the picture is absent
    bool left_out = false;  ///< there is a picture, but it is not in the page
};

/// A view and what its section shows of it.
struct PageView {
    const ViewResult* view = nullptr;
    std::string anchor;   ///< fragment of its section
    std::string picture;  ///< data URI of its view.webp; empty where there is none, or no room
    std::vector<PagePicture> pictures;
    bool has_planes = false;  ///< is there a planes.zvp?
};

/// So many views stand in the page as markup, rows and sections; so many the script shows at once of a page
/// that has more. The built-in suite and most runs of a user's own scenes have fewer.
inline constexpr std::size_t views_in_markup = 200;

/// The views, failed first, and what evidence run_folder has of them; their pictures are left out as yet.
std::vector<PageView> page_views(const Results& results, const std::filesystem::path& run_folder);

/// Reads pictures as far as the budget (bytes as text) goes, first the one of each view's card; returns what
/// they take of it.
std::size_t take_pictures(std::span<PageView> views, const std::filesystem::path& run_folder,
                          std::size_t budget);

/// The picture of a view's card as a data URI; empty where there is none.
std::string card_picture_of(const ViewResult& view, const std::filesystem::path& run_folder);

/// The run's likely cause in words, and the command to begin with; empty where nothing failed.
std::string html_answer(const Results& results);

/// A picture of every view, with its name and what was found; each leads to the view's section.
std::string html_cards(std::span<const PageView> views);

enum class Zeros { plain, quiet };

/// A column of the summary behind verdict and name.
struct SummaryColumn {
    std::string heading;     ///< markup
    std::string kind = "n";  ///< the classes of its cells
    Zeros zeros = Zeros::plain;
    std::string meaning = {};  ///< a hint at the heading
};
std::vector<SummaryColumn> summary_columns();

/// What stands in these columns for a view that was judged; a line break is a '\n'.
std::vector<std::string> summary_texts(const ViewResult& view);

/// The table of views, in their order; empty where there are none.
std::string html_summary(std::span<const PageView> views);

/// The first of some views as elements of the page that its script unpacks: deflated (RFC 1950), in base64.
struct PackedViews {
    std::vector<std::string> elements;
    std::size_t views = 0, bytes = 0;
};

/// What the script lists, searches and sorts, as many views as the budget (bytes) allows: elements "facts-0",
/// "facts-1" ... with a JSON array of arrays each, whose values are named by fact_names().
PackedViews packed_facts(std::span<const PageView> views, std::size_t budget);
std::vector<std::string> fact_names();

/// The pictures of views' cards, as many as the budget allows: elements "pictures-0", "pictures-1" ... with a
/// JSON array of sections_in_pack data URIs each, empty where there is none.
PackedViews packed_pictures(std::span<const PageView> views, const std::filesystem::path& run_folder,
                            std::size_t budget);

/// The sections of views, as many as the budget allows: elements "sections-0", "sections-1" ... with
/// sections_in_pack of them each.
PackedViews packed_sections(std::span<const PageView> views, std::size_t budget);
inline constexpr std::size_t sections_in_pack = 20;

/// What the viewer reads, as elements of the page: the run, and of each view's planes.zvp as much as the
/// budget (bytes of the page) allows.
struct PagePlanes {
    Page elements;
    std::string omissions;  ///< a paragraph about what the page does not hold; empty where it holds all
};
PagePlanes page_planes(const Results& results, std::span<const PageView> views,
                       const std::filesystem::path& run_folder, std::size_t budget);

/// The section of one view; of most it is folded.
enum class Folded { yes, no };
std::string html_view(const PageView& page, Folded folded = Folded::yes);

/// The pixels that are not `agree`: "9 edge, 2 depth_tie"; "no difference".
std::string tally(const ClassCounts& counts);

/// A declared precision (JSON) in one line: "raster; transform float64, subpixel bits 8, watertight". Slacks
/// of 0.0 and what is not the case are left out.
std::string promise_in_words(const std::string& precision);

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
