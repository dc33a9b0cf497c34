// zproof waive add: from a pixel that somebody has looked at to an entry in the file.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <optional>

#include "cli/commands.h"
#include "cli/report_files.h"
#include "cli/waivers/waiver_file.h"
#include "compare/waivers/coverage.h"
#include "frame/folder_lock.h"
#include "frame/input_file.h"
#include "frame/joined.h"
#include "frame/whole_file.h"
#include "program/usage_error.h"
#include "reports/findings_file.h"
#include "reports/report_error.h"
#include "reports/result_file.h"
#include "reports/wording.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// The view that is meant; where the scene has several, somebody must say which.
const ViewResult& view_meant(const Results& results, const WaiveAddArguments& arguments) {
    std::vector<const ViewResult*> fitting;
    for (const ViewResult& view : results.views)
        if (view.scene == arguments.scene && (arguments.view.empty() || view.view == arguments.view))
            fitting.push_back(&view);
    if (fitting.size() == 1) return *fitting[0];
    throw UsageError{fitting.empty()
                         ? "waive add: the results have no view of scene '" + arguments.scene + "'" +
                               (arguments.view.empty() ? "" : " named '" + arguments.view + "'")
                         : "waive add: " + arguments.scene + " has the views " +
                               joined(fitting, ", ", &ViewResult::view) + "; say which with --view"};
}

std::vector<Finding> findings_of(const ViewResult& view, const fs::path& run_folder) {
    const fs::path file = run_folder / view.folder / "findings.csv";
    if (view.folder.empty())
        throw ReportError{file.string() + ": no such file; expected the evidence beside results.json"};
    return findings_from_csv(read_result(file, "the evidence beside results.json"), file.string());
}

struct Pixel {
    int x = 0, y = 0;
};

Pixel pixel_from(const std::string& word) {
    Pixel pixel;
    const char* const end = word.data() + word.size();
    const auto x = std::from_chars(word.data(), end, pixel.x);
    if (x.ec == std::errc{} && x.ptr != end && *x.ptr == ',')
        if (const auto y = std::from_chars(x.ptr + 1, end, pixel.y); y.ec == std::errc{} && y.ptr == end)
            return pixel;
    throw UsageError{"--pixel: expected X,Y such as 812,344, found '" + word + "'"};
}

/// The defect at the pixel; nothing else can be waived.
const Finding& defect_at(const std::vector<Finding>& findings, const std::string& word) {
    const Pixel pixel = pixel_from(word);
    const auto found =
        std::ranges::find_if(findings, [&](const Finding& f) { return f.x == pixel.x && f.y == pixel.y; });
    if (found == findings.end() || passes(found->verdict))
        throw UsageError{"--pixel " + word + ": is no defect in those results, so there is nothing to waive"};
    if (!is_waivable(found->verdict))
        throw UsageError{"--pixel " + word +
                         ": is 'invalid': the renderer breaks its contract there, and that "
                         "cannot be waived"};
    return *found;
}

/// The triangle that a finding is about: the candidate's, or where it saw none the reference's.
PrimitiveId triangle_of(const Finding& f) {
    return f.candidate.primitive != PrimitiveId::none ? f.candidate.primitive : f.reference.primitive;
}

void add_once(auto& list, const auto& item) {
    if (std::ranges::count(list, item) == 0) list.push_back(item);
}

decltype(Waiver::where) place_around(const std::vector<Finding>& seeds, WaiverReach reach, Resolution size) {
    AtTriangles triangles;
    AtPairs pairs;
    AtPixels pixels{.size = size, .rectangles = {}};
    for (const Finding& f : seeds) {
        add_once(triangles.triangles, triangle_of(f));
        add_once(pairs.pairs, std::pair{f.candidate.primitive, f.reference.primitive});
        pixels.rectangles.push_back({f.x, f.y, 1, 1});
    }
    if (reach == WaiverReach::triangle) return triangles;
    if (reach == WaiverReach::pair) return pairs;
    return pixels;
}

std::string free_id(const std::vector<Waiver>& waivers) {
    for (std::size_t number = waivers.size() + 1;; ++number) {
        std::string id = "W-" + std::to_string(number);
        if (std::ranges::find(waivers, id, &Waiver::id) == waivers.end()) return id;
    }
}

Day day_named(const std::string& word) {
    if (const auto day = day_from(word)) return *day;
    throw UsageError{"--expires: expected a day such as 2026-04-10, found '" + word + "'"};
}

/// A star in a scene's name would be a pattern.
std::string pattern_of(const std::string& name) {
    std::string pattern = name;
    std::ranges::replace(pattern, '*', '?');
    return pattern;
}

Waiver drafted(const WaiveAddArguments& arguments, const ViewResult& view,
               const std::vector<Finding>& findings) {
    std::vector<Finding> seeds;
    for (const std::string& word : arguments.pixels) seeds.push_back(defect_at(findings, word));
    Waiver waiver{.id = arguments.id,
                  .scene = pattern_of(view.scene),
                  .view = pattern_of(view.view),
                  .classes = {},
                  .where = place_around(seeds, arguments.reach, {view.width, view.height}),
                  .least = 1,
                  .most = 1,
                  .reason = arguments.reason,
                  .link = arguments.link,
                  .created = arguments.gate.today.value_or(this_day()),
                  .expires = day_named(arguments.expires),
                  .scene_sha256 = view.scene_sha256,
                  .origin = ""};
    for (const Finding& seed : seeds) add_once(waiver.classes, seed.verdict);
    const auto count =
        std::ranges::count_if(findings, [&](const Finding& f) { return applies_to(waiver, f); });
    waiver.least = waiver.most = std::uint64_t(count);
    return waiver;
}

std::string text_of(const fs::path& file) {
    std::error_code failure;  // what cannot be looked at may be there
    if (fs::status(file, failure).type() == fs::file_type::not_found) return empty_waiver_file();
    return read_input(file, {.words = "a file of waivers (.toml)"});
}

}  // namespace

ExitCode execute(const WaiveAddArguments& arguments) {
    const fs::path& file = arguments.gate.waivers;
    if (file.empty()) throw UsageError{"waive add: expected --waivers FILE.toml, the file to add to"};
    const Results results = read_results(arguments.results);
    const ViewResult& view = view_meant(results, arguments);
    Waiver waiver = drafted(arguments, view, findings_of(view, folder_of_results(arguments.results)));
    const fs::path& target = arguments.common.out.empty() ? file : arguments.common.out;
    const FolderLock lock(folder_of(target));  // others add and prune before or after
    const std::string before = text_of(file);
    if (waiver.id.empty()) waiver.id = free_id(parse_waivers(before, file.string()));
    const std::string after = before + (before.ends_with('\n') ? "\n" : "\n\n") + waiver_text(waiver);
    parse_waivers(after, file.string());  // the same rules as for one that was written by hand
    write_whole_file(target, after);
    std::cout << (arguments.common.is_quiet() ? one_line(waiver.id) + "\n" : printable(waiver_text(waiver)));
    return ExitCode::proven;
}

}  // namespace zproof
