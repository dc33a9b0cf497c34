// Lookups per second of every texture filter on one thread: a 1024 x 1024 texture of noise on a plane that
// runs to the horizon, 256 x 256 pixels, processor time. Figures for people: nothing depends on them.
//
//     filter_bench [METHOD]
#include <cstdio>
#include <ctime>
#include <string_view>

#include "tests/support/footprints.h"
#include "tests/support/worked_setup.h"
#include "texture/catalogue.h"

namespace {

using namespace zproof::texture;

std::vector<Footprint> plane() {
    const auto map = worked::texels_from_raster(30);
    std::vector<Footprint> footprints;
    for (int y = worked::first_row; y < worked::side; ++y)
        for (int x = 0; x < worked::side; ++x)
            footprints.push_back(footprint(map, x, y, Derivatives::analytic));
    return footprints;
}

double seconds_since(std::clock_t start) { return double(std::clock() - start) / CLOCKS_PER_SEC; }

void time_one(const Method& method, const LinearImage& image, const std::vector<Footprint>& footprints) {
    const std::clock_t start = std::clock();
    const Sampler sampler = method.prepare(image, {});
    const double preparing = seconds_since(start);
    glm::dvec4 sum{0};
    std::size_t lookups = 0;
    const std::clock_t lookup_start = std::clock();
    while (seconds_since(lookup_start) < 0.5) {
        for (const Footprint& seen : footprints) sum += sampler.colour(seen);
        lookups += footprints.size();
    }
    const double each = seconds_since(lookup_start) / double(lookups);
    std::printf("%-22s prepared in %7.1f ms, %8.0f ns a lookup, %7.2f M/s (mean %.4f)\n", method.name.c_str(),
                preparing * 1e3, each * 1e9, 1e-6 / each, sum.r / double(lookups));
}

}  // namespace

int main(int argc, char** argv) {
    const LinearImage image = random_image(1024, 1024, 1);
    const std::vector<Footprint> footprints = plane();
    for (const Method& method : methods())
        if (argc < 2 || method.name == std::string_view{argv[1]}) time_one(method, image, footprints);
}
