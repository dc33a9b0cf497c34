// What building a summed-area table costs beside a memset of it: 4096 x 4096 texels, 32-bit sums, in turn,
// medians of 21: processor time of all threads, so that a busy machine disturbs it little. The memory is
// already there; both write all of it. A figure for people: nothing depends on it.
//
//     sat_bench [THREADS]...     1 and 2 where nothing is said
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>
#include <vector>

#include "texture/code_sums.h"
#include "texture/summed_area.h"

namespace {

using namespace zproof::texture;
using Values = std::vector<std::uint32_t>;

template <class Work>
double milliseconds(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> times) {
    std::ranges::nth_element(times, times.begin() + std::ptrdiff_t(times.size() / 2));
    return times[times.size() / 2];
}

/// As many pieces as threads, each by the library's own memset.
void clear(Values& values, int byte) {
    const int pieces = tbb::this_task_arena::max_concurrency();
    tbb::parallel_for(0, pieces, [&](int piece) {
        const std::size_t from = values.size() * std::size_t(piece) / std::size_t(pieces),
                          to = values.size() * std::size_t(piece + 1) / std::size_t(pieces);
        std::memset(values.data() + from, byte, (to - from) * sizeof(std::uint32_t));
    });
}

template <class Code>
void time_build(const char* name, int channels) {
    constexpr int side = 4096;
    std::mt19937 dice(1);
    std::vector<Code> codes(std::size_t{side} * side * std::size_t(channels));
    for (Code& code : codes) code = Code(dice());
    Values sums(codes.size());
    std::vector<double> build, memset, ratio;
    for (int run = 0; run < 21; ++run) {
        memset.push_back(milliseconds([&] { clear(sums, run); }));
        build.push_back(milliseconds([&] { sum_codes(Codes<Code>{side, side, channels, codes}, sums); }));
        ratio.push_back(build.back() / memset.back());
    }
    std::printf("%-22s memset %7.2f ms, table %7.2f ms, ratio %.2f (least %.2f, most %.2f)\n", name,
                median(memset), median(build), median(ratio), std::ranges::min(ratio),
                std::ranges::max(ratio));
}

/// What the filters use: 64-bit sums of four float32 channels.
void time_filters_table() {
    constexpr int side = 1024;
    const LinearImage image{side, side, std::vector<glm::vec4>(std::size_t{side} * side, glm::vec4(0.25f))};
    std::vector<double> build;
    for (int run = 0; run < 5; ++run)
        build.push_back(milliseconds([&] { SummedArea(image, SatStorage::integer); }));
    std::printf("%-22s %.1f ns a texel\n", "RGBA, float, 64 bits", median(build) * 1e6 / side / side);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> threads;
    for (int i = 1; i < argc; ++i) threads.push_back(std::atoi(argv[i]));
    if (threads.empty()) threads = {1, 2};
    for (const int count : threads)
        tbb::task_arena(count).execute([&] {
            std::printf("%d thread%s\n", count, count == 1 ? "" : "s");
            time_build<std::uint8_t>("grey, 8 bits", 1);
            time_build<std::uint16_t>("grey, 16 bits", 1);
            time_build<std::uint8_t>("RGB, 8 bits", 3);
            time_build<std::uint8_t>("RGBA, 8 bits", 4);
        });
    time_filters_table();
}
