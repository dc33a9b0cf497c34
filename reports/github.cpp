#include "reports/formats.h"

#include <algorithm>
#include <vector>

#include "reports/diagnosis_words.h"
#include "reports/waiver_status.h"
#include "reports/wording.h"

namespace zproof {

namespace {

struct Annotation {
    std::string kind, file;  ///< "error" or "warning"; file empty: none
    int line = 1;
    std::string title, message;
};

std::string replaced(const std::string& text, std::string_view wanted) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    std::string safe;
    for (const char c : printable(text))
        if (wanted.find(c) == std::string_view::npos)
            safe += c;
        else
            safe += {'%', hex[std::size_t(c) >> 4], hex[std::size_t(c) & 15]};
    return safe;
}

std::string in_words(const Annotation& a) {
    const std::string place =
        a.file.empty() ? "" : "file=" + github_property(a.file) + ",line=" + std::to_string(a.line) + ",";
    return "::" + a.kind + " " + place + "title=" + github_property(a.title) +
           "::" + github_message(a.message) + "\n";
}

std::size_t worst_class(const ViewResult& v) {
    for (std::size_t i = v.counts.size(); i-- > 0;)
        if (v.counts[i] > v.waived[i] && is_defect(PixelClass(i))) return i;
    return 0;
}

/// What cannot be read says least about the renderer, so it comes after what is wrong.
bool is_worse(const ViewResult* a, const ViewResult* b) {
    if (worst_class(*a) != worst_class(*b)) return worst_class(*a) > worst_class(*b);
    return unwaived_defects(*a) > unwaived_defects(*b);
}

std::string message_of(const ViewResult& v) {
    std::string text;
    const auto add = [&](const std::string& line) { text += (text.empty() ? "" : "\n") + line; };
    if (!v.message.empty()) add(v.message);
    if (unwaived_defects(v) > 0) add(counted(unwaived_defects(v), "pixel") + " fail the gate");
    if (v.diagnosis) add(zproof::in_words(*v.diagnosis));
    if (!v.worst.empty() && v.worst[0].waiver.empty() && is_defect(v.worst[0].finding.verdict)) {
        add(v.worst[0].explanation);
        add(v.worst[0].command);
    }
    return text;
}

Annotation annotation_of(const ViewResult& v) {
    return {.kind = "error",
            .file = v.source == "suite" ? "" : v.source,
            .line = 1,
            .title = "zproof: " + v.scene + (v.view.empty() ? "" : "/" + v.view) + " " +
                     std::string(in_words(v.outcome)),
            .message = message_of(v)};
}

Annotation annotation_of(const WaiverStatus& status, Strictness strictness) {
    const std::string& origin = status.waiver->origin;
    const std::size_t colon = origin.rfind(':');
    const std::string line = colon == std::string::npos ? "" : origin.substr(colon + 1);
    const bool is_number =
        !line.empty() && line.size() < 9 && line.find_first_not_of("0123456789") == std::string::npos;
    return {.kind = fails(status, strictness) ? "error" : "warning",
            .file = origin.substr(0, colon),
            .line = is_number ? std::stoi(line) : 1,
            .title = "zproof: waiver " + status.waiver->id + " " + std::string(name_of(status.state)),
            .message = advice_for(status)};
}

std::vector<Annotation> annotations_of(const Results& results) {
    std::vector<Annotation> all;
    for (const WaiverStatus& status : waiver_statuses(results))
        if (!advice_for(status).empty()) all.push_back(annotation_of(status, results.strictness));
    std::vector<const ViewResult*> failing;
    for (const ViewResult* view : failed_first(results))
        if (view->outcome != Outcome::proven) failing.push_back(view);
    std::ranges::stable_sort(failing, is_worse);
    for (const ViewResult* view : failing) all.push_back(annotation_of(*view));
    return all;
}

std::string lines_of(const std::vector<Annotation>& annotations, const std::string& kind) {
    std::string text;
    std::size_t count = 0;
    for (const Annotation& a : annotations)
        if (a.kind == kind && ++count <= most_annotations) text += in_words(a);
    if (count > most_annotations)
        text += "and " + counted(count - most_annotations, "more " + kind) +
                "; the summary and results.json have them all\n";
    return text;
}

}  // namespace

std::string to_github(const Results& results) {
    const std::vector<Annotation> annotations = annotations_of(results);
    return lines_of(annotations, "error") + lines_of(annotations, "warning");
}

std::string github_message(const std::string& text) { return replaced(text, "%\r\n"); }
std::string github_property(const std::string& text) { return replaced(text, "%\r\n:,"); }

}  // namespace zproof
