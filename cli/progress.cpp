#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>

#include "reports/wording.h"

namespace zproof {
namespace {

constexpr std::size_t bar_width = 24;
constexpr const char* erase_line = "\r\x1b[K";

/// "defective   room / main  0.3 s". Names come from files: what could write to the terminal is taken out of
/// them.
std::string line_for(const ViewResult& view) {
    std::string line{name_of(view.outcome)};
    line.resize(std::max<std::size_t>(line.size(), 10), ' ');
    line += "  " + one_line(view.scene);
    if (!view.view.empty()) line += " / " + one_line(view.view);
    if (!view.message.empty()) line += ": " + one_line(view.message);
    return line + "  " + fixed(seconds(view.times), 1) + " s\n";
}

}  // namespace

bool is_terminal(int file_descriptor) {
    const char* term = std::getenv("TERM");
    return isatty(file_descriptor) == 1 && term != nullptr && std::string{term} != "dumb";
}

ProgressStyle resolve(ProgressStyle wish) {
    if (wish != ProgressStyle::automatic) return wish;
    return is_terminal(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::lines;
}

Progress::Progress(std::ostream& out, ProgressStyle style, std::size_t scene_count)
    : out_(out), style_(style), scene_count_(scene_count) {}

Progress::~Progress() { clear_bar(); }

void Progress::begin_scene(const std::string& name) {
    ++current_;
    scene_ = name;
}

void Progress::begin_stage(const std::string& stage) {
    if (style_ == ProgressStyle::bar) draw_bar(stage);
}

void Progress::finish_view(const ViewResult& view) {
    if (style_ == ProgressStyle::lines)
        out_ << "[" << current_ << "/" << scene_count_ << "] " << line_for(view) << std::flush;
    if (style_ != ProgressStyle::bar || view.outcome == Outcome::proven) return;
    clear_bar();
    out_ << line_for(view) << std::flush;
}

void Progress::draw_bar(const std::string& stage) {
    const std::size_t done = scene_count_ == 0 ? 0 : bar_width * (current_ - 1) / scene_count_;
    const std::string text = one_line(scene_ + ": " + stage);
    out_ << erase_line << "[" << std::string(done, '#') << std::string(bar_width - done, '.') << "] "
         << current_ << "/" << scene_count_ << "  " << text.substr(0, 40) << std::flush;
}

void Progress::clear_bar() {
    if (style_ == ProgressStyle::bar) out_ << erase_line << std::flush;
}

}  // namespace zproof
