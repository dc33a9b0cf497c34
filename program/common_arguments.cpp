#include "program/common_arguments.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <unistd.h>
#include <algorithm>
#include <cstdlib>
#include <thread>

#include "program/work_progress.h"

namespace zproof {

int available_threads() { return std::clamp(int(std::thread::hardware_concurrency()), 1, 1024); }

ProgressStyle progress_of(const CommonArguments& common) {
    if (common.is_quiet()) return ProgressStyle::silent;
    if (common.progress != ProgressStyle::automatic) return common.progress;
    return is_terminal(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::lines;
}

ProgressStyle progress_beside_lines(const CommonArguments& common) {
    const ProgressStyle style = progress_of(common);
    const bool is_repetition = style == ProgressStyle::lines && common.progress == ProgressStyle::automatic;
    return is_repetition ? ProgressStyle::none : style;
}

bool wants_colours(const CommonArguments& common) {
    if (common.colour != ColourMode::automatic) return common.colour == ColourMode::always;
    const char* no_color = std::getenv("NO_COLOR");  // no-color.org: any value but the empty one
    const bool is_refused = no_color != nullptr && *no_color != '\0';
    return !is_refused && !common.is_printed_to_file() && is_terminal(STDOUT_FILENO);
}

void on_threads(int count, const std::function<void()>& work) {
    const tbb::global_control limit{tbb::global_control::max_allowed_parallelism, std::size_t(count)};
    tbb::task_arena arena{count};
    arena.execute(work);
}

}  // namespace zproof
