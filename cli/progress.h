/// How far a run is, told on stderr. Says nothing about verdicts that the reports do not say.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "program/work_progress.h"
#include "reports/results.h"

namespace zproof {

/// A scene of the run, and about how much work it is, in any unit.
struct SceneWork {
    std::string scene;
    double work = 1;
};

/// What each scene is taken to cost: the seconds that it took in an earlier run of the same output folder
/// (results.json), the mean of those for a scene that has none, 1 where nothing is known of any.
std::vector<SceneWork> expected_work(const std::vector<std::string>& scenes, const Results& earlier);

class Progress {
  public:
    /// The stream must outlive this object. style: not automatic.
    Progress(std::ostream& out, ProgressStyle style, std::vector<SceneWork> scenes);

    void begin_scene(const std::string& name);
    void expect_views(std::size_t count);        ///< the scene's work is shared out evenly among them
    void begin_stage(const std::string& stage);  ///< "render main"
    void on_stage(std::function<void(const std::string&)> hear) { hear_stage_ = std::move(hear); }
    void end_view();                    ///< its share of the work is done
    void finish_scene();                ///< all of it, whatever came of its views
    void tell(const ViewResult& view);  ///< as soon as it is judged, or cannot be

  private:
    std::ostream& out_;
    ProgressStyle style_;
    std::vector<SceneWork> scenes_;
    std::size_t begun_ = 0;
    double left_ = 0, per_view_ = 0;  ///< work of the scene in hand
    WorkProgress work_;
    std::function<void(const std::string&)> hear_stage_;
};

}  // namespace zproof
