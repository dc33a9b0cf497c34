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

std::string bar(int done, int all) {
    const int full = std::min(bar_width, all == 0 ? 0 : bar_width * done / all);
    return "[" + std::string(std::size_t(full), '#') + std::string(std::size_t(bar_width - full), '.') + "]";
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

void StudyProgress::begin_unit(const std::string& what) {
    seconds_ += watch_.lap();
    const std::string text = one_line(view_ + ": " + what);
    const std::string count = std::to_string(begun_) + "/" + std::to_string(units_);
    if (style_ == ProgressStyle::lines) out_ << "[" << count << "] " << text << left() << "\n" << std::flush;
    if (style_ == ProgressStyle::bar)
        out_ << erase_line << bar(begun_, units_) << " " << count << left() << "  " << text.substr(0, 50)
             << std::flush;
    ++begun_;
}

/// Every unit is taken to last as long as those before it did.
std::string StudyProgress::left() const {
    return begun_ == 0 ? "" : "  " + time_left(seconds_ / begun_ * (units_ - begun_));
}

}  // namespace zproof
