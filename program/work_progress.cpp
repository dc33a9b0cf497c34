#include "program/work_progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>

#include "reports/wording.h"

namespace zproof {
namespace {

constexpr std::size_t bar_width = 24, longest_name = 50;
constexpr const char* erase_line = "\r\x1b[K";

std::string two_digits(int value) {
    const std::string digits = std::to_string(value);
    return value < 10 ? "0" + digits : digits;
}

std::string bar(double share) {
    const auto full = std::size_t(double(bar_width) * share);
    return "[" + std::string(full, '#') + std::string(bar_width - full, '.') + "] ";
}

}  // namespace

bool is_terminal(int file_descriptor) {
    const char* term = std::getenv("TERM");
    return isatty(file_descriptor) == 1 && term != nullptr && std::string{term} != "dumb";
}

std::string time_left(double seconds) {
    const int whole = int(std::floor(std::max(0.0, seconds) + 0.5)), hours = whole / 3600,
              minutes = whole / 60 % 60;
    const std::string clock =
        hours > 0 ? std::to_string(hours) + ":" + two_digits(minutes) : std::to_string(minutes);
    return clock + ":" + two_digits(whole % 60) + " left";
}

std::string left_in_words(const Measured& so_far, Estimate estimate) {
    const auto& [seconds, done, all] = so_far;
    if (done <= 0 || (estimate == Estimate::from_half_of_the_work && all - done > done)) return "";
    const double left = seconds / done * (all - done);
    return left < 0.5 ? "" : "  " + time_left(left);
}

WorkProgress::WorkProgress(std::ostream& out, ProgressStyle style, double work, Estimate estimate)
    : out_(out), style_(style), all_(work), estimate_(estimate) {}

WorkProgress::~WorkProgress() {
    if (style_ == ProgressStyle::bar) out_ << erase_line << std::flush;
}

void WorkProgress::begin(const std::string& what, double work) {
    advance(in_hand_);
    in_hand_ = work;
    if (style_ == ProgressStyle::lines)
        out_ << "[" << percent() << "] " << one_line(whole_ + what) << left() << "\n" << std::flush;
    if (style_ == ProgressStyle::bar) draw(what);
}

void WorkProgress::advance(double work) {
    seconds_ += watch_.lap();
    done_ += work;
    in_hand_ = 0;
}

void WorkProgress::mention(const std::string& what) {
    if (style_ == ProgressStyle::bar) draw(what);
}

void WorkProgress::say(std::ostream& results, const std::string& line) {
    if (style_ == ProgressStyle::bar) out_ << erase_line << std::flush;
    results << printable(line) << std::flush;
}

std::string WorkProgress::left() const { return left_in_words({seconds_, done_, all_}, estimate_); }

void WorkProgress::draw(const std::string& what) {
    const double share = all_ > 0 ? std::clamp(done_ / all_, 0.0, 1.0) : 0;
    out_ << erase_line << bar(share) << percent() << left() << "  "
         << one_line(whole_ + what).substr(0, longest_name) << std::flush;
}

std::string WorkProgress::percent() const {
    const double share = all_ > 0 ? std::clamp(done_ / all_, 0.0, 1.0) : 0;
    const std::string number = std::to_string(int(100 * share));
    return std::string(3 - std::min<std::size_t>(3, number.size()), ' ') + number + "%";
}

}  // namespace zproof
