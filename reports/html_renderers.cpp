#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/html_parts.h"
#include "reports/renderer_record.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using nlohmann::json;

std::string number_cell(const std::string& text) { return "<td class=\"n\">" + text + "</td>"; }

/// The views compared, in words: "11 of 44" where it was not compared in all.
std::string compared(const RendererRecord& r) {
    return grouped(r.views) + (r.not_compared > 0 ? " of " + grouped(r.views + r.not_compared) : "");
}

/// What a sample is a sample of; empty where it was asked about every pixel.
std::string sample_remark(const RendererRecord& r) {
    if (r.pixels == r.of_pixels) return "";
    return "<p class=\"fine\">asked about " + sample_words(r.pixels, r.of_pixels, r.seed) + "</p>";
}

/// JSON with a blank after every comma, so that a narrow column can break it.
std::string breakable(const std::string& json_text) {
    std::string text;
    for (const char c : json_text) text += c == ',' ? std::string{", "} : std::string{c};
    return text;
}

/// The name of a key or of a value, in words: "depth buffer".
std::string spaced(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string facts_of(const Results& results, const RendererRecord& r) {
    for (const RendererFacts& facts : results.renderers)
        if (facts.name == r.name)
            return escaped(facts.version) + (facts.version.empty() ? "" : "<br>") +
                   escaped(ids_in_words(facts)) + "<details><summary>" +
                   escaped(promise_in_words(facts.precision)) + "</summary><code>" +
                   escaped(breakable(facts.precision)) + "</code></details>";
    return "";
}

std::string record_row(const Results& results, const RendererRecord& r) {
    const std::string absent =
        r.absent.empty() ? "" : "<p class=\"fine\">not compared: " + escaped(one_line(r.absent)) + "</p>";
    return "<tr><td><strong>" + escaped(one_line(r.name)) + "</strong><br>" + r.role + "</td>" +
           number_cell(compared(r)) + number_cell(grouped(r.pixels)) + "<td class=\"n defects" +
           (r.defects == 0 ? " zero" : "") + "\">" + grouped(r.defects) + "</td>" +
           number_cell(rounded(r.depth_error_over_bound)) + number_cell(rounded(r.edge_error_over_bound)) +
           number_cell(grouped(r.unlike_candidate)) + "<td class=\"words\">" + facts_of(results, r) +
           sample_remark(r) + absent + "</td></tr>\n";
}

std::string id_agreement_row(const std::vector<std::string>& names, const ViewResult& v, std::size_t i) {
    std::string cells = "<th>" + escaped(one_line(names[i])) + "</th>";
    for (std::size_t j = 0; j < names.size(); ++j)
        cells += number_cell(i == j ? "–" : grouped(v.id_agreement.same[i][i] - v.id_agreement.same[i][j]));
    return "<tr>" + cells + "</tr>\n";
}

/// Those whose frames the id agreement counts, in its order.
std::vector<std::string> compared_names(const ViewResult& v) {
    std::vector<std::string> names{v.candidate, v.reference};
    for (const OracleResult& w : v.oracles)
        if (w.absent.empty()) names.push_back(w.name);
    return names;
}

std::string id_agreement_table(const ViewResult& v) {
    const std::vector<std::string> names = compared_names(v);
    std::string head = "<th></th>", rows;
    for (std::size_t i = 0; i < names.size(); ++i) {
        head += "<th class=\"n\">" + escaped(one_line(names[i])) + "</th>";
        rows += id_agreement_row(names, v, i);
    }
    return "<div><h3>Pixels that name different triangles</h3><table class=\"counts\"><tr>" + head +
           "</tr>\n" + rows + "</table><p class=\"fine\">All of them name the same triangle at " +
           grouped(v.id_agreement.unanimous) + " of " + counted(v.id_agreement.same[0][0], "pixel") +
           ".</p></div>\n";
}

/// Class by class, how far two pictures lie apart.
std::string picture_words(const PictureDifferences& differences) {
    std::string text = "; colours in linear light:";
    for (std::size_t i = 0; i < differences.size(); ++i)
        if (const PictureDifference& d = differences[i]; d.pixels > 0)
            text += " " + std::string(name_of(PixelClass(i))) + " RMS " + rounded(d.rms) + ", largest " +
                    rounded(d.largest) + " (" + counted(d.pixels, "pixel") + ")";
    return text;
}

std::string oracle_item(const ViewResult& v, const OracleResult& w) {
    const std::string name = "<strong>" + escaped(w.name) + "</strong>: ";
    if (!w.absent.empty()) return "<li>" + name + escaped(one_line(w.absent)) + "</li>\n";
    std::string text = "<li>" + name + counted(defect_count(w.counts), "defect") + " (" + tally(w.counts) +
                       "), depth error at most " + rounded(w.depth.max_error_over_bound) +
                       " times its bound, edges at most " + rounded(w.edges.max_error_over_bound) +
                       " times eps";
    if (w.sample)
        text +=
            "; asked about " +
            sample_words(w.sample->pixels, std::uint64_t(v.width) * std::uint64_t(v.height), w.sample->seed) +
            (w.sample->fewer_because.empty() ? ""
                                             : ", fewer than usual: " + escaped(w.sample->fewer_because));
    if (w.picture) text += picture_words(*w.picture);
    if (!w.no_picture.empty()) text += "; no picture: " + escaped(one_line(w.no_picture));
    for (const ReportedFinding& f : w.worst)
        text += "<br><span class=\"fine\">" + escaped(f.explanation) + "</span> <code>" + escaped(f.command) +
                "</code>";
    return text + "</li>\n";
}

}  // namespace

std::string tally(const ClassCounts& counts) {
    std::string text;
    for (std::size_t i = 1; i < counts.size(); ++i)
        if (counts[i] > 0)
            text +=
                (text.empty() ? "" : ", ") + grouped(counts[i]) + " " + std::string(name_of(PixelClass(i)));
    return text.empty() ? "no difference" : text;
}

std::string promise_in_words(const std::string& precision) {
    const json declared = json::parse(precision, nullptr, false);
    if (!declared.is_object()) return "";
    std::string kind, text;
    for (const auto& [key, value] : declared.items()) {
        const bool is_no_slack = value.is_number_float() && value == 0.0;
        if (value == false || is_no_slack || value.is_structured()) continue;
        std::string said = value.is_string() ? spaced(value.get<std::string>()) : value.dump();
        if (key == "kind")
            kind = std::move(said);
        else
            text += (text.empty() ? "" : ", ") + spaced(key) + (value == true ? "" : " " + said);
    }
    return kind + (text.empty() ? "" : "; " + text);
}

std::string html_renderers(const Results& results) {
    const std::vector<RendererRecord> records = renderer_records(results);
    if (records.empty()) return "";
    std::string rows;
    for (const RendererRecord& r : records) rows += record_row(results, r);
    const Unanimity all = unanimity(results);
    std::string heads = "<th>renderer</th>";
    for (const std::string_view head : {"views", "pixels", "defects", "error / bound,<br>depth",
                                        "error / bound,<br>edges", "pixels unlike<br>the candidate"})
        heads += "<th class=\"n\">" + std::string(head) + "</th>";
    return "<section>\n<h2>Renderers</h2>\n<div class=\"wide\"><table class=\"summary\"><thead><tr>" + heads +
           "<th>who it says it is, what it declares</th></tr></thead><tbody>\n" + rows +
           "</tbody></table></div>\n<p class=\"fine\">Each is judged by what it declares, against the "
           "reference. All that were compared name the same triangle at " +
           grouped(all.unanimous) + " of " + grouped(all.pixels) + " pixels.</p>\n</section>\n";
}

std::string html_oracles(const ViewResult& v) {
    if (v.oracles.empty()) return "";
    std::string items;
    for (const OracleResult& w : v.oracles) items += oracle_item(v, w);
    return "<div><h3>Oracles</h3><ul>" + items + "</ul></div>\n" + id_agreement_table(v);
}

}  // namespace zproof
