#include "reports/formats.h"

#include <algorithm>

#include "reports/diagnosis_words.h"
#include "reports/run_causes.h"
#include "reports/wording.h"

namespace zproof {

namespace {

struct Suite {
    std::string name;
    std::vector<const ViewResult*> cases;
};

/// The suites in order of first appearance. A view that never met a reference is under "none".
std::vector<Suite> suites_of(const Results& results) {
    std::vector<Suite> suites;
    for (const ViewResult& view : results.views) {
        const std::string name = view.reference.empty() ? "none" : view.reference;
        auto place = std::ranges::find(suites, name, &Suite::name);
        if (place == suites.end()) place = suites.insert(place, Suite{name, {}});
        place->cases.push_back(&view);
    }
    return suites;
}

bool is_failure(const ViewResult* v) {
    return v->outcome == Outcome::defective || v->outcome == Outcome::undecided ||
           v->outcome == Outcome::not_judged;
}

bool is_error(const ViewResult* v) {
    return v->outcome == Outcome::unreadable || v->outcome == Outcome::internal_error;
}

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + escaped(one_line(value)) + "\"";
}

std::string totals(const std::vector<const ViewResult*>& cases) {
    double time = 0;
    for (const ViewResult* v : cases) time += seconds(v->times);
    return attribute("tests", std::to_string(cases.size())) +
           attribute("failures", std::to_string(std::ranges::count_if(cases, is_failure))) +
           attribute("errors", std::to_string(std::ranges::count_if(cases, is_error))) +
           attribute("skipped", "0") + attribute("time", fixed(time, 3));
}

/// The class of the worst defect; "expectation" where pixels are sound but the view did not show what it
/// must.
std::string failure_type(const ViewResult& v) {
    if (v.outcome != Outcome::defective) return std::string(name_of(v.outcome));
    for (std::size_t i = v.counts.size(); i-- > 0;)
        if (v.counts[i] > v.waived[i] && is_defect(PixelClass(i))) return std::string(name_of(PixelClass(i)));
    return "expectation";
}

std::string defect_sentence(const ViewResult& v) {
    std::string sentence = counted(unwaived_defects(v), "defective pixel");
    for (std::size_t i = 0; i < v.counts.size(); ++i)
        if (v.counts[i] > v.waived[i] && is_defect(PixelClass(i)))
            sentence += ", " + grouped(v.counts[i] - v.waived[i]) + " " + std::string(name_of(PixelClass(i)));
    return sentence;
}

std::string headline(const ViewResult& v) {
    if (!v.message.empty()) return v.message;
    return v.outcome == Outcome::not_judged ? "nothing was judged" : defect_sentence(v);
}

std::string story(const ViewResult& v) {
    std::string text = v.diagnosis ? one_line(in_words(*v.diagnosis)) + "\n" : "";
    for (std::size_t i = 0; i < std::min<std::size_t>(10, v.worst.size()); ++i)
        text += one_line(v.worst[i].explanation) + "\n    " + one_line(v.worst[i].command) + "\n";
    return text;
}

std::string complaint(const ViewResult& v) {
    if (v.outcome == Outcome::proven) return "";
    const std::string element = is_error(&v) ? "error" : "failure";
    const std::string type = failure_type(v);
    return "      <" + element + attribute("type", type) + attribute("message", headline(v)) + ">" +
           escaped(story(v)) + "</" + element + ">\n";
}

/// "2 defective pixels let pass by waiver W-1": said also where the case passes.
std::string waiver_note(const ViewResult& v) {
    std::string text;
    for (const WaiverUse& use : v.waivers)
        if (use.waived > 0)
            text += counted(use.waived, "defective pixel") + " let pass by waiver " + one_line(use.id) + "\n";
    return text;
}

std::string system_out(const ViewResult& v) {
    std::string text = waiver_note(v);
    if (!v.folder.empty()) text += "[[ATTACHMENT|" + one_line(v.folder) + "/view.webp]]";
    return text.empty() ? "" : "      <system-out>" + escaped(text) + "</system-out>\n";
}

std::string test_case(const ViewResult& v) {
    return "    <testcase" + attribute("classname", v.scene) + attribute("name", v.view) +
           attribute("time", fixed(seconds(v.times), 3)) + ">\n" + complaint(v) + system_out(v) +
           "    </testcase>\n";
}

/// The cause of the whole run, in each suite.
std::string properties(const Results& results) {
    const std::string cause = cause_in_words(results);
    if (cause.empty()) return "";
    return "    <properties>\n      <property" + attribute("name", "cause") + attribute("value", cause) +
           "/>\n    </properties>\n";
}

void write_suite(const TextSink& out, const Suite& suite, const std::string& properties) {
    out("  <testsuite" + attribute("name", suite.name) + totals(suite.cases) + ">\n" + properties);
    for (const ViewResult* v : suite.cases) out(test_case(*v));
    out("  </testsuite>\n");
}

}  // namespace

void write_junit(const TextSink& out, const Results& results) {
    out("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", "zproof") +
        totals(failed_first(results)) + ">\n");
    const std::string of_the_run = properties(results);
    for (const Suite& suite : suites_of(results)) write_suite(out, suite, of_the_run);
    out("</testsuites>\n");
}

std::string to_junit(const Results& results) {
    return collected([&](const TextSink& out) { write_junit(out, results); });
}

}  // namespace zproof
