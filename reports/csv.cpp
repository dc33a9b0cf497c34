#include "reports/formats.h"

#include <initializer_list>

#include "frame/joined.h"
#include "reports/wording.h"

namespace zproof {

namespace {

/// Quoted where it must be. A spreadsheet takes what begins with one of =+-@ for a formula: a quote keeps it
/// from that.
std::string field(const std::string& text) {
    std::string plain = one_line(text);
    if (!plain.empty() && std::string_view{"=+-@"}.find(plain[0]) != std::string_view::npos)
        plain.insert(0, 1, '\'');
    return csv_field(plain);
}

std::string row(std::initializer_list<std::string> fields) { return joined(fields, ",") + "\n"; }

/// Everything before the class.
std::string beginning(const ViewResult& v) {
    std::string text =
        row({field(v.scene) + "," + field(v.view), field(v.source), v.scene_sha256, field(v.candidate),
             field(v.reference), std::to_string(v.width), std::to_string(v.height),
             std::to_string(v.triangles), std::string(name_of(v.outcome))});
    text.back() = ',';
    return text;
}

std::string gate_word(PixelClass c) { return passes(c) ? "passes" : is_defect(c) ? "fails" : "undecided"; }

std::string rows_of(const ViewResult& v) {
    if (!was_judged(v)) return beginning(v) + ",,,," + field(v.message) + "\n";
    std::string rows;
    for (std::size_t i = 0; i < v.counts.size(); ++i)
        rows +=
            beginning(v) + row({std::string(name_of(PixelClass(i))), gate_word(PixelClass(i)),
                                std::to_string(v.counts[i]), std::to_string(v.waived[i]), field(v.message)});
    return rows;
}

}  // namespace

void write_csv(const TextSink& out, const Results& results) {
    out("scene,view,source,scene_sha256,candidate,reference,width,height,triangles,outcome,class,gate,pixels,"
        "waived,message\n");
    for (const ViewResult& view : results.views) out(rows_of(view));
}

std::string to_csv(const Results& results) {
    return collected([&](const TextSink& out) { write_csv(out, results); });
}

}  // namespace zproof
