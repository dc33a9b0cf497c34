/// How far the run is, told on stderr. Says nothing about verdicts that the reports do not say.
#pragma once

#include <iosfwd>
#include <string>

#include "cli/arguments.h"
#include "reports/results.h"

namespace zproof {

/// Is this file descriptor a terminal that understands cursor movements?
bool is_terminal(int file_descriptor);

/// The style that `automatic` stands for here.
ProgressStyle resolve(ProgressStyle wish);

class Progress {
  public:
    /// The stream must outlive this object. style: not automatic.
    Progress(std::ostream& out, ProgressStyle style, std::size_t scene_count);
    ~Progress();  ///< clears the bar
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void begin_scene(const std::string& name);
    void begin_stage(const std::string& stage);  ///< "render main"
    void finish_view(const ViewResult& view);    ///< also for a scene that could not be judged

  private:
    void draw_bar(const std::string& stage);
    void clear_bar();

    std::ostream& out_;
    ProgressStyle style_;
    std::size_t scene_count_, current_ = 0;
    std::string scene_;
};

}  // namespace zproof
