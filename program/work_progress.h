/// How far long work is, and about how long it will still take, told on stderr.
#pragma once

#include <iosfwd>
#include <string>

#include "program/settings.h"
#include "program/stopwatch.h"

namespace zproof {

/// Is this file descriptor a terminal that understands cursor movements?
bool is_terminal(int file_descriptor);

/// "2:05 left"; "1:02:05 left" from an hour on.
std::string time_left(double seconds);

/// When the time left is told first: at once where the units of work are alike; else when no more is
/// extrapolated than was seen.
enum class Estimate { from_the_start, from_half_of_the_work };

/// What was measured so far.
struct Measured {
    double seconds = 0, done = 0, all = 0;
};

/// "  2:05 left"; empty where that is no estimate yet, and where it is less than half a second.
std::string left_in_words(const Measured& so_far, Estimate estimate);

/// Work is counted in units of any kind: each is taken to last as long as those before it did on the average.
class WorkProgress {
  public:
    /// The stream must outlive this object. style: not automatic. `work`: all of it, as far as known.
    WorkProgress(std::ostream& out, ProgressStyle style, double work,
                 Estimate estimate = Estimate::from_the_start);
    ~WorkProgress();  ///< clears the bar
    WorkProgress(const WorkProgress&) = delete;
    WorkProgress& operator=(const WorkProgress&) = delete;

    void expect_more(double work) { all_ += work; }  ///< a scene has more views than one
    /// From here on what comes is like what was seen: a whole view.
    void estimate_from_here() { estimate_ = Estimate::from_the_start; }
    void within(const std::string& whole) { whole_ = whole; }  ///< what the next pieces are parts of: a view

    /// Ends the piece in hand and begins the next.
    void begin(const std::string& what, double work = 1);

    /// Ends the piece in hand, where its work was begun without begin().
    void advance(double work);

    /// Names what is being done, which is no piece of its own. Draws the bar; says nothing in lines.
    void mention(const std::string& what);

    /// Prints a line of results; a bar makes way for it.
    void say(std::ostream& results, const std::string& line);

    std::string left() const;  ///< left_in_words() of what was done

  private:
    void draw(const std::string& what);
    std::string percent() const;

    std::ostream& out_;
    ProgressStyle style_;
    double all_, done_ = 0, in_hand_ = 0, seconds_ = 0;
    Estimate estimate_;
    Stopwatch watch_;
    std::string whole_;
};

}  // namespace zproof
