// One piece of work for callgrind to count the instructions of: `./dev bench --check` (bench/figures.py).
//
//     zproof_work          the names of all pieces
//     zproof_work NAME     does it once, on one thread
#include <tbb/task_arena.h>

#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "bench/scenes.h"
#include "compare/judge.h"
#include "filters/methods/catalogue.h"
#include "filters/stored/code_sums.h"
#include "math/processor.h"
#include "oracle/embree.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/rasterizer.h"
#include "tests/support/footprints.h"
#include "tests/support/worked_setup.h"

namespace zproof::bench {

/// What is counted: everything below it.
[[gnu::noinline]] void counted(const std::function<void()>& work) { work(); }

namespace {

using Piece = std::function<void()>;

View small(View view) {
    view.width = 480, view.height = 270;
    return view;
}

Piece drawing(const rasterizer::Kernel& kernel, TimedScene (*make)()) {
    return [=] {
        const TimedScene timed = make();
        rasterizer::Pipeline pipeline({}, kernel);
        counted([&] { pipeline.render(timed.scene, small(timed.view)); });
    };
}

Piece judging(TimedScene (*make)()) {
    return [=] {
        const TimedScene timed = make();
        const View view = small(timed.view);
        const Frame candidate = rasterizer::render(timed.scene, view),
                    reference = oracle::Embree{timed.scene}.trace(view);
        counted([&] {
            judge(timed.scene, view, {candidate, rasterizer::precision()},
                  {reference, oracle::embree_precision()});
        });
    };
}

/// What is the scene's Embree's too: its own instructions are counted along.
Piece tracing(TimedScene (*make)()) {
    return [=] {
        const TimedScene timed = make();
        const oracle::Embree embree{timed.scene};
        counted([&] { embree.trace(small(timed.view)); });
    };
}

Piece summing() {
    return [] {
        constexpr int side = 512;
        const std::vector<std::uint8_t> codes(std::size_t{side} * side, 77);
        std::vector<std::uint32_t> sums(codes.size());
        counted([&] { texture::sum_codes(texture::Codes<std::uint8_t>{side, side, 1, codes}, sums); });
    };
}

Piece looking_up(const texture::Method& method) {
    return [=] {
        const texture::Sampler sampler = method.prepare(texture::random_image(256, 256, 1), {});
        const auto map = texture::worked::texels_from_raster(30);
        counted([&] {
            std::vector<texture::Footprint> seen(texture::worked::side);
            std::vector<glm::dvec4> colours(seen.size());
            for (int y = texture::worked::first_row; y < texture::worked::side; y += 4) {
                for (int x = 0; x < texture::worked::side; ++x)
                    seen[std::size_t(x)] = texture::with_cone_of_its_steps(
                        texture::footprint(map, x, y, texture::Derivatives::analytic));
                texture::look_up(sampler, seen, colours);
            }
        });
    };
}

std::map<std::string, Piece> pieces() {
    std::map<std::string, Piece> all;
    const std::map<std::string, TimedScene (*)()> scenes{
        {"room", room}, {"ripples", [] { return ripples(250, 125); }}, {"soup", soup}};
    for (const auto& [name, make] : scenes) {
        for (const rasterizer::Kernel& kernel : available_of(rasterizer::kernels))
            all["rasterizer " + std::string{kernel.name} + " " + name] = drawing(kernel, make);
        all["judge " + name] = judging(make);
        all["oracle " + name] = tracing(make);
    }
    all["sat grey"] = summing();
    for (const texture::Method& method : texture::methods())
        all["filter " + method.name] = looking_up(method);
    return all;
}

}  // namespace
}  // namespace zproof::bench

int main(int argc, char** argv) {
    const auto pieces = zproof::bench::pieces();
    if (argc == 1)
        for (const auto& [name, piece] : pieces) std::cout << name << "\n";
    if (argc == 1) return 0;
    const auto found = pieces.find(argv[1]);
    if (found == pieces.end()) return 2;
    tbb::task_arena(1).execute(found->second);
}
