#include "filters/report/crow_page.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "filters/report/table_cells.h"
#include "filters/study/claims.h"
#include "reports/page_parts.h"
#include "reports/pictures.h"
#include "reports/viridis.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study;

constexpr std::string_view own_style = R"css(
.trio {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(270px, 1fr)); gap: 1.2rem; margin: 1.2rem 0;
}
.trio img { image-rendering: pixelated; border-radius: 0; }
.kernels {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(150px, 1fr)); gap: 1rem; margin: 1rem 0;
}
.kernels img { image-rendering: pixelated; border-radius: 0; }
.answers td, .answers th { padding-right: 1.4rem; white-space: nowrap; }
blockquote { margin: 0 0 0.6rem; padding-left: 1rem; border-left: 3px solid var(--line); font-style: italic; }
p { max-width: 52rem; }
)css";

std::string cell(const std::string& text, bool is_number) {
    return std::string{is_number ? "<td class=\"n\">" : "<td>"} + escaped(text) + "</td>";
}

std::string row(const std::vector<std::string>& cells, bool first_is_text) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) text += cell(cells[i], i > 0 || !first_is_text);
    return "<tr>" + text + "</tr>\n";
}

std::string table(const std::vector<std::string>& heads, const std::string& rows, bool first_is_text) {
    std::string text;
    for (std::size_t i = 0; i < heads.size(); ++i)
        text +=
            std::string{i > 0 || !first_is_text ? "<th class=\"n\">" : "<th>"} + escaped(heads[i]) + "</th>";
    return "<div class=\"wide\"><table class=\"answers\"><thead><tr>" + text + "</tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

std::string caption_of(const StudyResults& results, const std::string& label) {
    const auto& methods = results.views.at(0).methods;
    const auto method = std::ranges::find(methods, label, &MethodScore::label);
    if (method == methods.end()) return "Area averaging: the exact mean over every pixel.";
    const auto value = [&](const char* metric) { return value_of(results, *method, "interior", metric); };
    return label + ": PSNR " + fixed(value("psnr"), 2) + " dB, blur " + fixed(value("blur"), 3) + ", alias " +
           fixed(value("alias"), 3) + ", FLIP " + fixed(value("flip"), 3) + "; " +
           fixed(method->cost.texels, 1) + " texels a pixel, " + bytes_in_words(method->cost.bytes_stored) +
           " stored";
}

std::string figure_of(const StudyResults& results, const std::vector<CrowPicture>& pictures) {
    std::string text;
    for (const CrowPicture& one : pictures)
        text += page_figure(png_uri(picture_of_light(one.picture)), caption_of(results, one.label));
    return "<section>\n<h2>Crow's comparison</h2>\n<p>The same plane, three ways of reading its texture, and "
           "what all "
           "of them are after. " +
           escaped(truth_in_words(results.truth)) + ".</p>\n<div class=\"trio\">\n" + text +
           "</div>\n</section>\n";
}

/// Dark where the weight is 0, white at the greatest; a square around the region's centre.
Plane<Rgb8> picture_of(const Kernel& kernel, const glm::dvec2& centre) {
    constexpr int shown = 33;
    const auto greatest = *std::ranges::max_element(kernel.weights);
    Plane<Rgb8> picture({shown, shown});
    for (int y = 0; y < shown; ++y)
        for (int x = 0; x < shown; ++x) {
            const int column = (int(centre.x) + x - shown / 2 + kernel.columns) % kernel.columns,
                      row = (int(centre.y) + y - shown / 2 + kernel.rows) % kernel.rows;
            const std::size_t place = std::size_t(row) * std::size_t(kernel.columns) + std::size_t(column);
            const auto tone = channel(std::sqrt(std::clamp(kernel.weights[place] / greatest, 0.0, 1.0)));
            picture.at(x, y) = {tone, tone, tone};
        }
    return picture;
}

std::string answers_of(const CrowQuestion& question) {
    std::string rows, kernels;
    for (const CrowAnswer& answer : question.answers) {
        rows += row({answer.method, fixed(answer.value, 4), fixed(answer.rmse, 4), fixed(answer.texels, 1),
                     fixed(answer.kernel.deviation.x, 2) + " x " + fixed(answer.kernel.deviation.y, 2)},
                    true);
        kernels += page_figure(png_uri(picture_of(answer.kernel, question.centre)), answer.method);
    }
    return table({"method", "returned at the first place", "RMS error, all places", "texels read",
                  "deviation of its weights, texels"},
                 rows, true) +
           "<p class=\"fine\">The weights on the texels around that place (square root of the weight over "
           "the "
           "greatest):</p>\n<div class=\"kernels\">\n" +
           kernels + "</div>\n";
}

std::string levels_of(const std::vector<BetweenLevels>& levels) {
    std::string rows;
    for (const BetweenLevels& one : levels)
        rows += row({shortest(one.side) + " x " + shortest(one.side), std::to_string(one.level),
                     fixed(one.by_logarithm, 4), fixed(one.by_width, 4), fixed(one.rmse, 4)},
                    true);
    return table(
        {"region", "finer level", "by log2 of the side", "by the side itself", "RMS error of trilinear-gl"},
        rows, true);
}

std::string section(const std::string& quote, const std::string& answer, const std::string& evidence) {
    return "<section>\n<blockquote>" + escaped(quote) + "</blockquote>\n<p>" + escaped(answer) + "</p>\n" +
           evidence + "</section>\n";
}

const CrowAnswer& answer_by(const CrowQuestion& question, std::string_view method) {
    return *std::ranges::find(question.answers, method, &CrowAnswer::method);
}

std::string neighbourhood(const CrowQuestion& q) {
    const CrowAnswer &exact = answer_by(q, "exact"), &mip = answer_by(q, "trilinear-gl");
    return section(
        "What would the mip-map return for an average over a 5x5 neighborhood at location (u0, v0)?",
        "Not that average. It blends bilinear reads of level 2, whose texels are means of 4 x 4, and of "
        "level 3, of "
        "8 x 8: eight stored values that reach over up to 16 x 16 texels. At (u0, v0) = (" +
            fixed(q.centre.x, 2) + ", " + fixed(q.centre.y, 2) + ") of a noise texture it returns " +
            fixed(mip.value, 4) + " where the mean over the region is " + fixed(exact.value, 4) +
            "; its weights spread " + fixed(mip.kernel.deviation.x / exact.kernel.deviation.x, 2) +
            " times as wide as the square's. A summed-area table returns the mean itself, from the corners "
            "of its box.",
        answers_of(q));
}

std::string fraction(const std::vector<BetweenLevels>& levels) {
    return section("How do we measure the fractional distance between levels?",
                   "By the logarithm of the region's side: level k stands for a side of 2^k texels, so 5 x 5 "
                   "lies log2(5) - 2 = "
                   "0.3219 of the way from level 2 to level 3. Measured by the side itself, as some "
                   "renderers blend, it would be "
                   "(5 - 4) / 4 = 0.25; the two differ by at most 0.0861. Neither makes the blend the mean "
                   "over the region: the "
                   "error is there for whole levels too.",
                   levels_of(levels));
}

std::string oblong(const CrowQuestion& straight, const CrowQuestion& turned) {
    const auto error = [](const CrowQuestion& q, const std::string& method) {
        return fixed(answer_by(q, method).rmse, 4);
    };
    return section("What if you need to average over a non-square region?",
                   "One level of a mip map knows squares only. Over 16 x 2 texels the longer side asks for "
                   "level 4 and blurs the "
                   "short one (RMS error " +
                       error(straight, "trilinear-gl") +
                       "). A summed-area table takes the rectangle as it is (" +
                       error(straight, "sat-affine") +
                       "). Turned by 45 degrees, the rectangle's bounding box is a square again, and the "
                       "table is hardly better off than the mip map (" +
                       error(turned, "sat-affine") + " against " + error(turned, "trilinear-gl") +
                       "): Crow's method is exact along the texture's axes only. Methods that read along the "
                       "region's own longer "
                       "axis keep most of their accuracy.",
                   "<h3>16 x 2</h3>\n" + answers_of(straight) + "<h3>16 x 2, turned by 45 degrees</h3>\n" +
                       answers_of(turned));
}

}  // namespace

std::string crow_page(const StudyResults& results, const std::vector<CrowPicture>& pictures,
                      const CrowAnswers& answers) {
    return page_head("Crow 1984", own_style) +
           "<body>\n<header>\n<h1>Point sampled, mip mapped, summed-area table</h1>\n<p>After F. C. Crow, "
           "Summed-area "
           "tables for texture mapping, SIGGRAPH 1984, and the questions that a lecture asks beside his "
           "figure. The "
           "answers are computed by the methods themselves, on white noise of " +
           std::to_string(answers.texture_side) + " x " + std::to_string(answers.texture_side) +
           " texels, at " + std::to_string(answers.places) + " places.</p>\n<p class=\"facts\">zproof " +
           escaped(results.version) + " · " + escaped(results.compiler) + "</p>\n</header>\n<main>\n" +
           figure_of(results, pictures) + neighbourhood(answers.questions.at(0)) + fraction(answers.levels) +
           oblong(answers.questions.at(1), answers.questions.at(2)) + "</main>\n" + page_end();
}

}  // namespace zproof
