#include "cli/filters/study_progress.h"

#include <algorithm>
#include <ostream>

#include "reports/wording.h"

namespace zproof {
namespace {

constexpr int bar_width = 24;
constexpr const char* erase_line = "\r\x1b[K";

std::string two_digits(int value) {
    const std::string digits = std::to_string(value);
    return value < 10 ? "0" + digits : digits;
}

}  // namespace

std::string time_left(double seconds) {
    const int whole = int(std::max(0.0, seconds) + 0.5), hours = whole / 3600, minutes = whole / 60 % 60;
    const std::string clock =
        hours > 0 ? std::to_string(hours) + ":" + two_digits(minutes) : std::to_string(minutes);
    return clock + ":" + two_digits(whole % 60) + " left";
}

StudyProgress::StudyProgress(std::ostream& out, ProgressStyle style, int units)
    : out_(out), style_(style), units_(units) {}

StudyProgress::~StudyProgress() {
    if (style_ == ProgressStyle::bar) out_ << erase_line << std::flush;
}

void StudyProgress::begin_view(const std::string& name) {
    view_ = name;
    if (style_ == ProgressStyle::lines) {
        seconds_ += watch_.lap();
        out_ << "[" << begun_ << "/" << units_ << "] " << one_line(view_);
        if (begun_ > 0) out_ << "  " << time_left(seconds_ / begun_ * (units_ - begun_));
        out_ << "\n" << std::flush;
    }
}

void StudyProgress::begin_unit(const std::string& what) {
    if (style_ == ProgressStyle::bar) tell(what);
    ++begun_;
}

/// Every unit is taken to last as long as those before it did.
void StudyProgress::tell(const std::string& what) {
    seconds_ += watch_.lap();
    const int full = std::min(bar_width, units_ == 0 ? 0 : bar_width * begun_ / units_);
    out_ << erase_line << "[" << std::string(std::size_t(full), '#')
         << std::string(std::size_t(bar_width - full), '.') << "] " << begun_ << "/" << units_;
    if (begun_ > 0) out_ << "  " << time_left(seconds_ / begun_ * (units_ - begun_));
    out_ << "  " << one_line(view_ + ": " + what).substr(0, 50) << std::flush;
}

}  // namespace zproof
