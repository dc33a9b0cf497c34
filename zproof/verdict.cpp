#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <tuple>
#include <utility>

#include "compare/diagnosis/diagnosis.h"
#include "compare/explanation/explain.h"
#include "compare/labels/labelled_frame.h"
#include "compare/pixel_class.h"
#include "frame/number_text.h"
#include "oracle/embree.h"
#include "reports/diagnosis_words.h"
#include "zproof/data.h"
#include "zproof/finding.h"
#include "zproof/ids.h"

namespace zproof::api {
namespace {

template <class Value, class Fact>
constexpr std::array<Value, pixel_class_count> of_every_class(Fact fact) {
    std::array<Value, pixel_class_count> all{};
    for (int i = 0; i < pixel_class_count; ++i) all[std::size_t(i)] = fact(facts_of(PixelClass(i)));
    return all;
}

constexpr auto names = of_every_class<std::string_view>([](const ClassFacts& f) { return f.name; });
constexpr auto colours = of_every_class<std::uint32_t>([](const ClassFacts& f) { return f.colour; });

/// After a sentence, what the frame itself says where its ids are coarser than triangles.
std::string own_words(const Verdict::Data& data, int x, int y) {
    const auto& labels = data.declared.labels;
    if (!labels || labels->are_absent || data.judged.primitive.at(x, y) == PrimitiveId::none) return "";
    return label_sentence(*labels, data.given.primitive.at(x, y));
}

Explanation::Triangle plain(const zproof::Candidate& triangle) {
    constexpr double grid = 256;  // edge distances are in 1/256 px
    const auto& d = triangle.edge_distance;
    return {.id = std::uint32_t(triangle.primitive),
            .depth_low = triangle.depth.low,
            .depth_truth = triangle.depth.truth,
            .depth_high = triangle.depth.high,
            .edge_distance_px = {d[0] / grid, d[1] / grid, d[2] / grid},
            .is_admissible = is_admissible(triangle.decision.admissibility)};
}

void require_inside(int x, int y, Size size) {
    if (x >= 0 && x < size.width && y >= 0 && y < size.height) return;
    throw InputError{"explain: pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                     ") lies outside of the view, which is " + size_text(size.width, size.height)};
}

/// The error of what makes it a defect. A NaN comes last.
double error_of(const zproof::Finding& f) {
    const double error = f.wrong_attribute ? f.wrong_attribute->error_over_bound : f.error_over_bound;
    return std::isnan(error) ? -1 : error;
}

constexpr auto& judged_columns = table_columns<zproof::Finding>;

/// The place of that name among the judge's columns; where it has none, their number.
constexpr std::size_t judged_column(std::string_view name) {
    const auto place = [&](const auto&... column) {
        std::size_t before = 0;
        (void)((column.record() == name || (++before, false)) || ...);
        return before;
    };
    return std::apply(place, judged_columns);
}

template <std::size_t i>
void tell(Finding& told, const zproof::Finding& f) {
    constexpr auto field = std::get<i>(finding_fields);
    constexpr std::size_t column = judged_column(field.first);
    auto& number = told.*field.second;
    if constexpr (std::string_view(field.first) == "is_defect")
        number = zproof::is_defect(f.verdict);
    else
        number =
            std::remove_reference_t<decltype(number)>(std::invoke(std::get<column>(judged_columns).get, f));
}

template <std::size_t... i>
Finding plain(const zproof::Finding& f, std::index_sequence<i...>) {
    Finding told{};
    (tell<i>(told, f), ...);
    return told;
}

}  // namespace

std::span<const std::string_view> class_names() { return names; }
std::span<const std::uint32_t> class_colours() { return colours; }
bool is_defect(std::uint32_t pixel_class) {
    return pixel_class < pixel_class_count && zproof::is_defect(PixelClass(pixel_class));
}

Finding plain(const zproof::Finding& f) {
    return plain(f, std::make_index_sequence<std::tuple_size_v<decltype(finding_fields)>>{});
}

RenderedFrame candidate_of(const Verdict::Data& data) { return {data.judged, data.declared.precision}; }
RenderedFrame reference_of(const Verdict::Data& data) {
    return {data.reference.data().frame, oracle::embree_precision()};
}

bool Verdict::is_proven() const { return defect_count() == 0 && undecidable_count(data().verdict) == 0; }
std::uint64_t Verdict::defect_count() const { return zproof::defect_count(data().verdict); }
std::span<const std::uint64_t> Verdict::counts() const { return data().verdict.counts; }
std::span<const Finding> Verdict::findings() const { return data().findings; }
const Scene& Verdict::scene() const { return data().scene; }
const View& Verdict::view() const { return data().view; }
const Frame& Verdict::reference() const { return data().reference; }
std::span<const std::uint32_t> Verdict::judged_id() const { return ids_of(data().judged); }
std::span<const float> Verdict::judged_depth() const { return data().judged.camera_depth.pixels(); }

std::span<const std::uint8_t> Verdict::classes() const {
    const std::span<const PixelClass> classes = data().verdict.classes.pixels();
    return {reinterpret_cast<const std::uint8_t*>(classes.data()), classes.size()};  // NOLINT: its own type
}

std::optional<Finding> Verdict::worst() const {
    const zproof::Finding* worst = nullptr;
    for (const zproof::Finding& f : data().verdict.findings)
        if (zproof::is_defect(f.verdict) && (!worst || error_of(f) > error_of(*worst))) worst = &f;
    return worst ? std::optional{plain(*worst)} : std::nullopt;
}

std::string Verdict::sentence(const Finding& finding) const {
    const auto& all = data().verdict.findings;
    const auto place = [](const auto& f) { return std::pair{int(f.y), int(f.x)}; };
    const auto found =
        std::ranges::lower_bound(all, place(finding), {}, place);  // they stand in raster order
    if (found == all.end() || place(*found) != place(finding))
        throw InputError{"sentence: the verdict has no finding at that pixel"};
    return in_words(data().scene.data().scene, *found) + own_words(data(), found->x, found->y);
}

Explanation Verdict::explain(int x, int y) const {
    require_inside(x, y, view().size());
    const zproof::Scene& scene = data().scene.data().scene;
    const PixelExplanation story =
        zproof::explain(scene, view().data().view, candidate_of(data()), reference_of(data()), {x, y});
    Explanation told{.finding = plain(story.finding),
                     .text = in_words(scene, story),
                     .triangles = {},
                     .is_background_admissible = is_admissible(story.background.admissibility)};
    if (const std::string own = own_words(data(), x, y); !own.empty()) told.text += own.substr(2) + "\n";
    for (const zproof::Candidate& triangle : story.candidates) told.triangles.push_back(plain(triangle));
    return told;
}

std::optional<Diagnosis> Verdict::diagnosis() const {
    const auto& labels = data().declared.labels;
    const auto found = diagnose(
        scene().data().scene, view().data().view, candidate_of(data()), reference_of(data()), data().verdict,
        {.said = labels ? std::optional(SaidLabels{*labels, data().given.primitive}) : std::nullopt});
    if (!found) return {};
    Diagnosis told{.text = in_words(*found), .cause = {}, .explained_share = 0, .defects = found->defects};
    if (found->cause) {
        told.cause = found->cause->name;
        told.explained_share = explained_share(*found->cause);
    }
    return told;
}

}  // namespace zproof::api
