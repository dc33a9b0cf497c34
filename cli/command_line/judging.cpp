// The commands that judge: run, compare, explain.
#include "cli/command_line/branches.h"
#include "cli/command_line/options.h"
#include "cli/commands.h"
#include "cli/gate/shard.h"
#include "cli/plan/explicit_words.h"
#include "cli/run_size.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr const char* compare_remark = R"(
The frames' own resolution is taken. Exit status as for run.)";

constexpr const char* plan_remark = R"(
Every view of every scene is given to one shard, longest first. Exit status: 0 written.)";

const std::map<std::string, ShardStatus> empty_shards{{"nothing", ShardStatus::is_the_verdict},
                                                      {"ok", ShardStatus::ok_where_empty}};
const std::map<std::string, PlanFormat> plan_formats{{"lines", PlanFormat::lines},
                                                     {"slurm", PlanFormat::slurm},
                                                     {"github", PlanFormat::github},
                                                     {"gitlab", PlanFormat::gitlab}};

/// SCENE, or a second frame where --scene names the scene.
void add_frames(CLI::App& app, CompareArguments& compare, RendererWords& words) {
    app.add_option(
           "CANDIDATE", words.candidate,
           "frame to be judged: .exr or .tif with id and Z, or IDS+DEPTHS, e.g. id.png+z.pfm; {sample} is a "
           "sample's index")
        ->required();
    auto* other =
        app.add_option("SCENE", compare.scene, std::string{scene_words} + "; with --scene: a frame");
    other->required();
    app.add_option_function<std::string>(
           "--scene",
           [&compare, &words, other](const std::string& scene) {
               words.reference = other->as<std::string>();
               compare.scene = scene;
           },
           "the scene, where both words are frames")
        ->type_name("SCENE");
}

/// Excluding one another, and a resolution of the caller's own.
void add_run_size(CLI::App& app, RunSize& size) {
    const auto flag = [&](const char* name, RunSize meant, const char* words) {
        return app.add_flag_callback(
            name, [&size, meant] { size = meant; }, words);
    };
    auto* quick = flag("--quick", RunSize::quick, "480 x 270, and no oracle beside Embree: seconds");
    auto* thorough =
        flag("--thorough", RunSize::thorough,
             "further resolutions, odd ones and 1 x 1 among them, and POV-Ray and OpenGL at every pixel");
    quick->excludes(thorough);
    for (auto* one : {quick, thorough})
        for (const char* other : {"--width", "--height"}) one->excludes(app.get_option(other));
}

/// They take the place of the suite, and nobody is asked beside Embree: 1000 take seconds.
void add_random(CLI::App& app, RandomChoice& random) {
    auto* count = app.add_option("--random", random.count,
                                 "judge so many random scenes, and shrink the first that fail")
                      ->check(CLI::Range(std::uint64_t{1}, most_random_scenes))
                      ->excludes(app.get_option("SCENE"));
    for (CLI::Option* option : add_random_choice(app, random)) option->needs(count);
}

/// What is not typed, where random scenes are asked for.
void choose_random(const RandomChoice& random, RunArguments& run, RendererWords& renderers) {
    run.scenes = random.words();
    if (!renderers.oracles) renderers.oracles = {{"none"}};
}

/// What is judged, and by whom: all that a plan fixes.
void add_run_words(CLI::App& app, CommandWords& words) {
    app.add_option("SCENE", words.run.scenes,
                   std::string{"'suite', a folder, or a "} + scene_words + "; none: the whole suite");
    add_models(app, words.run.models);
    add_renderer_options(app, words.renderers);
    add_ids_option(app, words.renderers);
    add_oracle_options(app, words.renderers);
    add_render_settings(app, words.run.settings);
    add_run_size(app, words.run.size);
    add_random(app, words.random);
    add_samples(app, words.run.settings);
    add_evidence(app, words.run.report);
    add_gate(app, words.run.report.gate);
}

void add_shard(CLI::App& app, CommandWords& words) {
    RunArguments& run = words.run;
    app.add_option("--plan", run.plan, "judge a shard of this plan (zproof plan), which states all the rest")
        ->group(machine_options);
    app.add_option("--shard", words.shard,
                   "the share of the views to judge: K of a plan, hash:K/N without one, or auto: the "
                   "environment says which (zproof merge puts shards together)")
        ->group(machine_options);
    auto* empty = add_choice(app, "--empty-shard", run.shard_status, empty_shards);
    empty->default_str("nothing")
        ->description("a shard without views ends with 4 (nothing), or with 0 (ok)")
        ->group(machine_options);
    app.add_flag_callback(
           "--exit-zero", [&run] { run.shard_status = ShardStatus::ok_where_written; },
           "of a shard: end with 0 once its results are written, since merged ones tell the verdict")
        ->group(machine_options)
        ->excludes(empty);
}

/// When the run ends before all is judged.
void add_early_end(CLI::App& app, EarlyEndRule& rule) {
    auto* many = app.add_option("--max-defects", rule.max_failed_views,
                                "end the run after so many views that failed, however many pixels each has");
    many->check(CLI::Range(1, 1'000'000))->group(machine_options);
    app.add_flag_callback(
           "-x", [&rule] { rule.max_failed_views = 1; }, "the same as --max-defects 1")
        ->group(machine_options)
        ->excludes(many);
    app.add_flag_callback(
           "--keep-going", [&rule] { rule.persistence = Persistence::keeps_going; },
           "go on where the first three views were refused in the same words")
        ->group(machine_options);
}

}  // namespace

Branch add_run(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("run", "render, ask the reference, judge, write the reports");
    add_run_words(app, words);
    add_report(app, words.run.report);
    add_shard(app, words);
    add_reference_cache(app, words.run.reference_cache);
    add_early_end(app, words.run.early_end);
    app.add_option("--only-failed", words.run.only_failed,
                   "results.json of an earlier run, or its folder: judge only the views that failed there")
        ->excludes(app.get_option("--plan"));
    add_settings_choice(app, words.settings);
    return {&app, [&words, &app] {
                RunArguments& run = words.run;
                if (!run.plan.empty()) require_machine_words(app);
                if (words.random.count > 0) choose_random(words.random, run, words.renderers);
                run.settings.resolution = resolution_for(run.size, run.settings.resolution);
                if (!words.renderers.oracles) words.renderers.oracles = oracles_for(run.size);
                run.renderers = chosen_renderers(words.renderers);
                run.shard = shard_from(words.shard, !run.plan.empty(), words.environment);
                if (words.shard.empty() && run.shard_status == ShardStatus::ok_where_written)
                    throw UsageError{"--exit-zero: is of shards; expected --shard beside it"};
                return command_of(run, "cannot judge");
            }};
}

Branch add_plan(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("plan", "share a run out among many machines");
    PlanArguments& plan = words.plan;
    add_run_words(app, words);
    add_common(app, plan.common, "the plan");
    app.add_option("--of", plan.shards, "how many shards")
        ->required()
        ->check(CLI::Range(1, most_shards))
        ->group(plan_options);
    app.add_option("--from", plan.earlier,
                   "results of an earlier run, which tell how long each view takes; several: of other "
                   "renderers or scenes")
        ->allow_extra_args(false)
        ->group(plan_options);
    add_choice(app, "--format", plan.format, plan_formats)
        ->default_str("lines")
        ->description("how the shards' commands are printed")
        ->group(plan_options);
    app.add_option("--config", words.settings.file,
                   "settings file; default: zproof.toml, where it is; or none")
        ->group(machine_options);
    app.add_option(
           "--profile", words.plan_profiles,
           "the table [profiles.NAME] of the settings file; several: a run of each, one renderer each")
        ->allow_extra_args(false)
        ->group(machine_options);
    app.footer(plan_remark);
    return {&app, [&words] { return command_of(words.plan, "cannot plan"); }};
}

Branch add_compare(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("compare", "judge frames that were rendered elsewhere");
    add_frames(app, words.compare, words.renderers);
    add_models(app, words.compare.models);
    app.add_option("--view", words.compare.view, "name of the view; needed where the scene has several")
        ->type_name("VIEW");
    add_precision_options(app, words.renderers);
    add_ids_option(app, words.renderers);
    add_reference_words(app, words.renderers);
    add_oracle_options(app, words.renderers);
    add_isa(app);
    add_samples(app, words.compare.settings);
    add_report(app, words.compare.report);
    add_evidence(app, words.compare.report);
    add_gate(app, words.compare.report.gate);
    add_settings_choice(app, words.settings);
    app.footer(compare_remark);
    return {&app, [&words] {
                words.compare.renderers = chosen_renderers(words.renderers);
                return command_of(words.compare, "cannot judge");
            }};
}

Branch add_explain(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("explain", "tell the whole story of one pixel");
    ExplainArguments& explain = words.explain;
    app.add_option("SCENE", explain.scene, scene_words)->required();
    app.add_option("X", explain.x, "pixel column, 0 = left")->required()->check(CLI::Range(0, 32767));
    app.add_option("Y", explain.y, "pixel row, 0 = top")->required()->check(CLI::Range(0, 32767));
    add_common(app, explain.common);
    add_models(app, explain.models);
    app.add_option("--view", explain.view, "name of the view; default: the scene's first")->type_name("VIEW");
    add_renderer_options(app, words.renderers);
    add_ids_option(app, words.renderers);
    add_stored_frame_options(app, words.renderers);
    add_render_settings(app, explain.settings);
    add_samples(app, explain.settings);
    add_settings_choice(app, words.settings);
    return {&app, [&words] {
                words.explain.renderers = chosen_renderers(words.renderers);
                return command_of(words.explain, "cannot judge");
            }};
}

}  // namespace zproof
