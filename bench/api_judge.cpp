// The public judge on arrays, again and again: milliseconds, a line each. bench/python_judge.py does the same
// in Python.
//
//   zproof_api_judge SCENE WIDTH HEIGHT TIMES
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "zproof/zproof.h"

int main(int argc, char** argv) {
    namespace zp = zproof::api;
    if (argc != 5) return std::cerr << "usage: zproof_api_judge SCENE WIDTH HEIGHT TIMES\n", 2;
    const zp::Scene scene = zp::Scene::load(argv[1], {std::atoi(argv[2]), std::atoi(argv[3])});
    const zp::View& view = scene.views().front();
    const zp::Frame frame = zp::render(scene, view);
    const std::vector<std::uint32_t> id{frame.id().begin(), frame.id().end()};
    const std::vector<float> depth{frame.depth().begin(), frame.depth().end()};
    for (int i = 0; i < std::atoi(argv[4]); ++i) {
        const auto start = std::chrono::steady_clock::now();
        const zp::Verdict verdict =
            zp::judge(scene, view, {.id = id, .depth = depth, .precision = "raster,transform=float64"});
        if (!verdict.is_proven()) return 1;
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        std::cout << took.count() << "\n";
    }
}
