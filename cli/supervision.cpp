#include "cli/supervision.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>

#include "cli/worker.h"
#include "program/interrupt.h"
#include "program/usage_error.h"
#include "renderers/registry.h"
#include "reports/json.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

class Supervision {
  public:
    Supervision(const std::vector<SceneSource>& sources, const RunConfig& config, Results& results)
        : sources_(sources), config_(config), results_(results) {}

    /// One worker until it ends. An interrupt that comes when everything is judged changes nothing any more.
    void judge_on(int threads) {
        Worker worker(sources_, next_, config_, threads);
        stage_.clear();
        while (const std::optional<Message> message = worker.next()) take(*message);
        const std::string how = worker.end();
        if (all_are_judged()) return;
        if (how.empty() && (is_over() || interrupted()))
            results_.ending = ending_of_the_left();
        else
            lose_scene(how.empty() ? "ended without a word" : how);
    }

    bool all_are_judged() const { return next_ == sources_.size(); }

    /// Nothing more is to be begun.
    bool is_over() const { return config_.early_end.is_due() || results_.ending != Ending::complete; }

    /// Those that were not begun; returns how many they are.
    std::size_t leave_the_rest() {
        const std::size_t left = sources_.size() - next_;
        if (left > 0) results_.ending = ending_of_the_left();
        while (next_ < sources_.size())
            results_.views.push_back(left_out(sources_[next_++], config_.early_end));
        return left;
    }

  private:
    Ending ending_of_the_left() const {
        return config_.early_end.is_due() ? Ending::stopped : Ending::interrupted;
    }

    void take(const Message& message) {
        switch (message.kind) {
            case Message::Kind::facts:
                return take_facts(results_from_message_pack(message.text));
            case Message::Kind::stage:
                stage_ = message.text;
                return;
            case Message::Kind::scene:
                return take_scene(results_from_message_pack(message.text));
            case Message::Kind::usage_error:
                throw UsageError{message.text};
            case Message::Kind::error:
                throw std::runtime_error{message.text};
            case Message::Kind::internal_error:
                throw std::logic_error{message.text};
        }
    }

    /// While the worker judges the first scene, this process asks the oracles that nobody named: POV-Ray
    /// takes a fifth of a second to say its version.
    void take_facts(Results facts) {
        results_.embree = std::move(facts.embree);
        if (!results_.renderers.empty()) return;  // from a worker before this one
        results_.renderers = std::move(facts.renderers);
        for (const OracleChoice& oracle : config_.renderers.oracles)
            if (oracle.need == OracleChoice::Need::welcome && absence_of(oracle.renderer).empty())
                results_.renderers.push_back(facts_of(oracle.renderer));
    }

    void take_scene(Results scene) {
        follow_progress();
        results_.ending = scene.ending;
        for (const ViewResult& view : scene.views) {
            config_.early_end.note(view);
            config_.causes.note(view);
            if (!view.folder.empty()) config_.names.take(fs::path(view.folder).filename().string());
        }
        std::ranges::move(scene.views, std::back_inserter(results_.views));
        stage_.clear();
    }

    void lose_scene(const std::string& how) {
        ViewResult lost = ended_by_fault(sources_[next_], config_, how, stage_);
        follow_progress();
        config_.progress.tell(lost);
        config_.early_end.note(lost);
        results_.views.push_back(std::move(lost));
        remove_unfinished_evidence();
    }

    /// What the worker's own has shown of a scene.
    void follow_progress() {
        config_.progress.begin_scene(sources_[next_++].name);
        config_.progress.finish_scene();
    }

    void remove_unfinished_evidence() const {
        std::set<std::string> finished;
        for (const ViewResult& view : results_.views)
            finished.insert(fs::path(view.folder).filename().string());
        std::error_code ignored, failure;
        for (auto i = fs::directory_iterator(config_.run_folder / "scenes", failure); !failure && i != end(i);
             i.increment(failure))
            if (!finished.contains(i->path().filename().string())) fs::remove_all(i->path(), ignored);
    }

    const std::vector<SceneSource>& sources_;
    const RunConfig& config_;
    Results& results_;
    std::size_t next_ = 0;  ///< the scene in hand
    std::string stage_;     ///< of it
};

}  // namespace

std::size_t judge_supervised(const std::vector<SceneSource>& sources, const RunConfig& config, int threads,
                             Results& results) {
    Supervision supervision(sources, config, results);
    do supervision.judge_on(threads);
    while (!supervision.all_are_judged() && !supervision.is_over() && !interrupted());
    return supervision.leave_the_rest();
}

}  // namespace zproof
