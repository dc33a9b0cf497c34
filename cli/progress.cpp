#include "cli/progress.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <ostream>

#include "reports/wording.h"

namespace zproof {
namespace {

/// "defective   room / main: 3 defects, err/bound 41.2  0.3 s". Names come from files: what could write to
/// the terminal is taken out of them.
std::string line_for(const ViewResult& view) {
    std::string line{name_of(view.outcome)};
    line.resize(std::max<std::size_t>(line.size(), 10), ' ');
    line += "  " + one_line(view.scene);
    if (!view.view.empty()) line += " / " + one_line(view.view);
    if (!view.message.empty()) line += ": " + one_line(view.message);
    if (was_judged(view))
        line += ": " + (defect_count(view) == 0 ? "" : counted(defect_count(view), "defect") + ", ") +
                "err/bound " + error_over_bound_words(view);
    constexpr std::size_t around = 40;  // the share that is done, and the times
    line = shortened(line, longest_line_bytes - around);
    const double took = seconds(view.times);
    return took > 0 ? line + "  " + fixed(took, 1) + " s" : line;  // one that was not begun took none
}

double all_of(const std::vector<SceneWork>& scenes) {
    return std::accumulate(scenes.begin(), scenes.end(), 0.0,
                           [](double sum, const SceneWork& scene) { return sum + scene.work; });
}

}  // namespace

std::vector<SceneWork> expected_work(const std::vector<std::string>& scenes, const Results& earlier) {
    std::map<std::string, double> took;
    for (const ViewResult& view : earlier.views)
        if (seconds(view.times) > 0) took[view.scene] += seconds(view.times);
    double known = 0;
    std::size_t count = 0;
    for (const std::string& scene : scenes)
        if (took.contains(scene)) known += took[scene], ++count;
    const double otherwise = count == 0 ? 1 : known / double(count);
    std::vector<SceneWork> work;
    for (const std::string& scene : scenes)
        work.push_back({scene, took.contains(scene) ? took[scene] : otherwise});
    return work;
}

Progress::Progress(std::ostream& out, ProgressStyle style, std::vector<SceneWork> scenes)
    : out_(out), style_(style), scenes_(std::move(scenes)), work_(out, style, all_of(scenes_)) {}

void Progress::begin_scene(const std::string& name) {
    left_ = per_view_ = begun_ < scenes_.size() ? scenes_[begun_].work : 0;
    ++begun_;
    work_.within(name + ": ");
}

void Progress::expect_views(std::size_t count) {
    per_view_ = left_ / double(std::max<std::size_t>(count, 1));
}

void Progress::begin_stage(const std::string& stage) {
    if (hear_stage_) hear_stage_(stage);
    work_.mention(stage);
}

void Progress::end_view() {
    const double part = std::min(per_view_, left_);
    work_.advance(part);
    left_ -= part;
}

void Progress::finish_scene() {
    work_.advance(left_);
    left_ = 0;
}

void Progress::tell(const ViewResult& view) {
    const std::string place = "[" + std::to_string(begun_) + "/" + std::to_string(scenes_.size()) + "] ";
    if (style_ == ProgressStyle::lines) out_ << place << line_for(view) << work_.left() << "\n" << std::flush;
    if (style_ == ProgressStyle::bar && view.outcome != Outcome::proven)
        work_.say(out_, line_for(view) + "\n");
}

}  // namespace zproof
