// The commands around the gate: merge, report, diff-results, waive, doctor.
#include "cli/command_line/branches.h"
#include "cli/command_line/options.h"
#include "cli/commands.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr const char* merge_remark = R"(
Exit status: that of the run, put together; 3 where the shards are not those of one run.)";

constexpr const char* report_remark = R"(
Exit status: 0 written; the verdict is not judged again.)";

constexpr const char* diff_remark = R"(
Exit status: 0 the same or better, 1 worse: a view is no longer proven, or gone, or has more defects.)";

constexpr const char* check_remark = R"(
Exit status: 0 all sound, 1 one has run out (--strict: or is not needed), 2 the file is malformed.)";

const std::map<std::string, WaiverReach> reaches{
    {"pair", WaiverReach::pair}, {"triangle", WaiverReach::triangle}, {"pixels", WaiverReach::pixels}};

constexpr const char* waivers_made = "the file of waivers as it becomes; default: that of --waivers";

Branch add_waive_list(CLI::App& waive, CommandWords& words) {
    CLI::App& app = *waive.add_subcommand("list", "every waiver, a line each, with the days it has left");
    add_common(app, words.waive_list.common);
    add_waiver_file(app, words.waive_list.gate);
    add_settings_choice(app, words.settings);
    return {&app, [&words] { return command_of(words.waive_list, "cannot list the waivers"); }};
}

Branch add_waive_check(CLI::App& waive, CommandWords& words) {
    CLI::App& app = *waive.add_subcommand("check", "are they well formed, in time, and needed?");
    add_common(app, words.waive_check.common);
    add_gate(app, words.waive_check.gate);
    app.add_option("--from", words.waive_check.results, "results.json of a run, to see which are needed");
    app.footer(check_remark);
    add_settings_choice(app, words.settings);
    return {&app, [&words] { return command_of(words.waive_check, "cannot check the waivers"); }};
}

Branch add_waive_prune(CLI::App& waive, CommandWords& words) {
    CLI::App& app = *waive.add_subcommand("prune", "remove those that have run out, or are not needed");
    add_common(app, words.waive_prune.common, waivers_made);
    add_waiver_file(app, words.waive_prune.gate);
    app.add_option("--from", words.waive_prune.results,
                   "results.json of a run: remove also those that let nothing pass there");
    add_settings_choice(app, words.settings);
    return {&app, [&words] { return command_of(words.waive_prune, "cannot prune the waivers"); }};
}

Branch add_waive_add(CLI::App& waive, CommandWords& words) {
    CLI::App& app = *waive.add_subcommand("add", "waive the defects around a pixel that was looked at");
    WaiveAddArguments& add = words.waive_add;
    add_common(app, add.common, waivers_made);
    add_waiver_file(app, add.gate);
    app.add_option("--from", add.results, "results.json of the run, its evidence beside it")->required();
    app.add_option("--scene", add.scene, "as the results call it")->type_name("SCENE")->required();
    app.add_option("--view", add.view, "needed where the scene has several")->type_name("VIEW");
    app.add_option("--pixel", add.pixels, "X,Y; more for more pixels of the same class")
        ->type_name("PIXEL")
        ->required()
        ->allow_extra_args(false);
    add_choice(app, "--reach", add.reach, reaches)
        ->default_str("pair")
        ->description(
            "what the waiver holds for in the view: pair: all pixels with the same two triangles; triangle: "
            "all with the candidate's triangle; pixels: those of --pixel alone");
    app.add_option("--id", add.id, "default: W- and a number");
    app.add_option("--reason", add.reason, "why it may stay for a while")->required();
    app.add_option("--link", add.link, "where it is being worked on")->required();
    app.add_option("--expires", add.expires, "last day, at most 180 from now: 2026-04-10")->required();
    add_settings_choice(app, words.settings);
    return {&app, [&words] { return command_of(words.waive_add, "cannot add a waiver"); }};
}

}  // namespace

Branch add_merge(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("merge", "put the shards of one run together");
    MergeArguments& merge = words.merge;
    app.add_option("SHARD", merge.shards, "output folders of zproof run --shard, all of them")->required();
    auto* plan = app.add_option("--plan", merge.plan, "the plan whose shards they are");
    app.add_flag_callback(
           "--partial", [&merge] { merge.missing = Missing::is_not_judged; },
           "what is missing of the plan is not judged; ends with 3")
        ->needs(plan);
    add_report(app, words.merge.report);
    add_settings_choice(app, words.settings);
    app.footer(merge_remark);
    return {&app, [&words] { return command_of(words.merge, "cannot merge"); }};
}

Branch add_report_again(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("report", "make a report again from results.json");
    ReportAgainArguments& again = words.report_again;
    app.add_option("RESULTS", again.results,
                   "results.json, or the folder of one; several: all their views; and folders of studies, "
                   "for the page")
        ->required();
    add_common(app, again.common, "file: .html, .json, .xml, .md or .csv; or - for stdout");
    app.add_option_function<std::string>(
           "--format", [&again](const std::string& word) { again.format = format_from(word); },
           "html, json, junit, md, github or csv; default: by the file's name")
        ->type_name("FORMAT");
    app.footer(report_remark);
    return {&app, [&words] { return command_of(words.report_again, "cannot report"); }};
}

Branch add_diff_results(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("diff-results", "what became better or worse between two runs");
    app.add_option("OLD", words.diff_results.before, "results.json, or the folder of one")->required();
    app.add_option("NEW", words.diff_results.after, "results.json, or the folder of one")->required();
    add_common(app, words.diff_results.common);
    app.add_flag_callback(
        "--json", [&words] { words.diff_results.format = DifferenceFormat::json; },
        "print JSON instead of a table");
    app.footer(diff_remark);
    return {&app, [&words] { return command_of(words.diff_results, "cannot compare the results"); }};
}

Branch add_waive(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("waive", "known defects that may stay for a while, with a reason");
    app.require_subcommand(0, 1);
    const std::vector<Branch> branches{add_waive_list(app, words), add_waive_check(app, words),
                                       add_waive_prune(app, words), add_waive_add(app, words)};
    return {
        &app, [branches] {
            for (const Branch& branch : branches)
                if (branch.app->parsed()) return branch.understood();
            throw UsageError{"waive: 'list', 'check', 'prune' or 'add' expected (see: zproof waive --help)"};
        }};
}

Branch add_doctor(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand(
        "doctor", "what is installed here, and which settings hold, each with where it comes from");
    add_common(app, words.doctor.common);
    add_settings_choice(app, words.settings);
    return {&app, [&words] {
                words.doctor.settings = words.settings;
                return command_of(words.doctor, "cannot examine");
            }};
}

}  // namespace zproof
