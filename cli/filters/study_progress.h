/// How far a study is, and about how long it will still take, told on stderr.
#pragma once

#include <iosfwd>
#include <string>

#include "cli/settings.h"
#include "cli/stopwatch.h"

namespace zproof {

/// "2:05 left"; "1:02:05 left" from an hour on.
std::string time_left(double seconds);

class StudyProgress {
  public:
    /// The stream must outlive this object. style: not automatic. `units`: of all work, as far as known.
    StudyProgress(std::ostream& out, ProgressStyle style, int units);
    ~StudyProgress();  ///< clears the bar
    StudyProgress(const StudyProgress&) = delete;
    StudyProgress& operator=(const StudyProgress&) = delete;

    void expect_more(int units) { units_ += units; }  ///< a scene has more views than one
    void begin_view(const std::string& name) { view_ = name; }
    void begin_unit(const std::string& what);

  private:
    std::string left() const;

    std::ostream& out_;
    ProgressStyle style_;
    int units_, begun_ = 0;
    double seconds_ = 0;
    Stopwatch watch_;
    std::string view_;
};

}  // namespace zproof
