/// What a study is to the command line: a file here, and a line in studies.cpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/arguments.h"
#include "program/work_progress.h"
#include "reports/pages/document.h"
#include "scenes/loaded.h"

namespace CLI {
class App;
}

namespace zproof {

/// One view of a scene, as a study is handed it.
struct StudiedView {
    const Scene& scene;
    const View& view;
    std::string stem;   ///< "room-door": begins the names of this view's items; unique, a file stem
    std::string title;  ///< "room / door"
};

/// Work in hand: what was asked, of which scenes, and whom to tell.
struct StudyTask {
    const StudyArguments& arguments;
    const std::vector<Loaded>& subjects;  ///< with the views that were asked for
    WorkProgress& progress;               ///< begin() is owed Study::units_per_view times a view
};

struct Study {
    std::string name, purpose;          ///< as typed; a line for --help
    std::vector<std::string> subjects;  ///< scenes where none is named
    Resolution resolution;              ///< where nobody says
    int units_per_view = 1;             ///< of progress
    /// Adds the study's own options; app and arguments outlive the parsing. May be empty.
    std::function<void(CLI::App&, StudyArguments&)> add_options;
    /// Title, introduction and sections; command and version are filled in by the caller. Runs in an arena of
    /// as many threads as were asked for, and ends early, with what is whole, where interrupted() says so.
    /// Throws UsageError, SceneError, OracleError.
    std::function<document::Document(const StudyTask&)> perform;
};

/// Every study, in the order of --help.
const std::vector<Study>& studies();

/// All views of all subjects in order, each announced to task.progress; stops where interrupted() says so.
void each_view(const StudyTask& task, const std::function<void(const StudiedView&)>& study_one);

/// One file per study: projection.cpp, ...
Study projection_study();
Study depth_study();
Study shading_study();
Study cost_study();

}  // namespace zproof
