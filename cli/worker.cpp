#include "cli/worker.h"

#include <malloc.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "cli/shrinker.h"
#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "oracle/scratch_folder.h"
#include "oracle/subprocess.h"
#include "program/common_arguments.h"
#include "program/exit_code.h"
#include "program/interrupt.h"
#include "program/usage_error.h"
#include "renderers/registry.h"
#include "reports/json.h"

namespace zproof {
namespace {

/// Candidate, reference, and the oracles that somebody named. Throws OracleError for one that is absent.
std::vector<RendererFacts> facts_of_named(const ChosenRenderers& renderers) {
    std::vector<RendererFacts> named;
    const auto call = [&](const RendererChoice& choice) {
        if (const std::string absent = absence_of(choice); !absent.empty())
            throw OracleError{name_of(choice) + ": " + absent};
        named.push_back(facts_of(choice));
    };
    call(renderers.candidate);
    call(renderers.reference);
    for (const OracleChoice& oracle : renderers.oracles)
        if (oracle.need != OracleChoice::Need::welcome) call(oracle.renderer);
    return named;
}

/// What the worker does, and where it tells of it.
struct Work {
    const std::vector<SceneSource>& sources;
    std::size_t first;
    const RunConfig& config;
    int threads;
    int to;

    void tell(Message::Kind kind, const std::string& text) const {
        if (!send(to, {kind, text})) _exit(int(ExitCode::internal));  // read only by one who is still there
    }

    void judge_scenes() const {
        Shrinker shrinker(config);
        for (std::size_t i = first; i < sources.size() && !interrupted(); ++i) {
            SceneReport report = run_scene(sources[i], config);
            for (ViewResult& view : report.views) shrinker.look_at(sources[i], view);
            Results results;
            results.ending = report.ending;
            results.views = std::move(report.views);
            tell(Message::Kind::scene, to_message_pack(results));
            malloc_trim(0);  // the next scene wants it in other pieces: kept, it would become more and more
            if (report.ending != Ending::complete || config.early_end.is_due()) return;
        }
    }

    void do_all() const {
        config.progress.on_stage([this](const std::string& stage) { tell(Message::Kind::stage, stage); });
        Results facts;
        facts.embree = oracle::embree_version();
        facts.renderers = facts_of_named(config.renderers);
        tell(Message::Kind::facts, to_message_pack(facts));
        on_threads(threads, [this] { judge_scenes(); });
    }
};

/// Ends the process: nothing that the other one made is taken apart here.
[[noreturn]] void work(const Work& all) {
    try {
        all.do_all();
    } catch (const UsageError& e) {
        all.tell(Message::Kind::usage_error, e.what());
    } catch (const std::runtime_error& e) {
        all.tell(Message::Kind::error, e.what());
    } catch (const std::exception& e) {
        all.tell(Message::Kind::internal_error, e.what());
    }
    _exit(0);
}

sigset_t all_interrupts() {
    sigset_t interrupts;
    sigemptyset(&interrupts);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&interrupts, number);
    return interrupts;
}

/// fork(), and in either process interrupts go where they should from the beginning: to the worker.
pid_t fork_worker() {
    const sigset_t interrupts = all_interrupts();
    sigset_t before;
    pthread_sigmask(SIG_BLOCK, &interrupts, &before);
    const pid_t id = fork();
    if (id == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        note_interrupts(SecondInterrupt::is_ignored);
    }
    hand_interrupts_to(std::max(id, 0));
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return id;
}

[[noreturn]] void refuse(const std::string& what) {
    throw std::runtime_error{what + ": " + std::strerror(errno)};
}

}  // namespace

Worker::Worker(const std::vector<SceneSource>& sources, std::size_t first, const RunConfig& config,
               int threads) {
    oracle::Pipe pipe = oracle::open_pipe();
    if (!pipe.from.is_open()) refuse("no pipe to another process");
    from_ = std::move(pipe.from);
    std::cout.flush();
    id_ = fork_worker();
    if (id_ < 0) refuse("no process can be started");
    if (id_ == 0) work({sources, first, config, threads, pipe.to.number()});
}

Worker::~Worker() {
    if (id_ == 0) return;
    ::kill(id_, SIGKILL);
    end();
}

std::string Worker::end() {
    hand_interrupts_to(0);
    from_.close();  // it may have more to tell than the pipe takes
    const oracle::Outcome outcome = oracle::outcome_of(oracle::status_at_end(id_));
    oracle::remove_scratch_folders_of(std::exchange(id_, 0));
    return outcome.succeeded() ? "" : oracle::in_words(outcome, {});
}

}  // namespace zproof
