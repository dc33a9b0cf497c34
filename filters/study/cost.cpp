#include "filters/study/cost.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <ctime>

#include "frame/joined.h"
#include "frame/number_text.h"
#include "rasterizer/textured_surface.h"

namespace zproof::study {

namespace {

using texture::Sampler;
using texture::Tap;

constexpr std::size_t line_bytes = 64;

/// Processor time of this thread: what others do on the machine does not count.
double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

using Samplers = std::vector<std::optional<Sampler>>;

Samplers prepared(const rasterizer::Texturing& texturing, const SourceTextures& textures) {
    Samplers samplers(textures.size());
    for (std::size_t i = 0; i < textures.size(); ++i) {
        if (!textures[i]) continue;
        samplers[i] = texturing.method.prepare(textures[i]->image, textures[i]->with(texturing.options));
    }
    return samplers;
}

std::uint64_t bytes_of(const Samplers& samplers) {
    std::uint64_t bytes = 0;
    for (const auto& sampler : samplers) {
        if (!sampler) continue;
        for (const texture::StoredImage& image : sampler->stored)
            bytes += std::uint64_t(image.width) * std::uint64_t(image.height) * image.bytes_per_texel;
    }
    return bytes;
}

/// Each image starts a line of its own.
std::size_t lines_touched(const Sampler& sampler, std::span<const Tap> taps) {
    std::vector<std::pair<int, std::size_t>> lines;
    for (const Tap& tap : taps) {
        const texture::StoredImage& image = sampler.stored[std::size_t(tap.image)];
        const std::size_t texel = std::size_t(tap.row) * std::size_t(image.width) + std::size_t(tap.column);
        const std::size_t first = texel * image.bytes_per_texel / line_bytes,
                          last = (texel * image.bytes_per_texel + image.bytes_per_texel - 1) / line_bytes;
        for (std::size_t line = first; line <= last; ++line) lines.emplace_back(tap.image, line);
    }
    std::ranges::sort(lines);
    return std::size_t(std::unique(lines.begin(), lines.end()) - lines.begin());
}

const Sampler& sampler_for(const Samplers& samplers, const Lookup& lookup) {
    return *samplers[std::size_t(lookup.material)];
}

void count_reads(const Samplers& samplers, std::span<const Lookup> lookups, Cost& cost) {
    std::uint64_t texels = 0, lines = 0;
    for (const Lookup& lookup : lookups) {
        const Sampler& sampler = sampler_for(samplers, lookup);
        const std::vector<Tap> taps = sampler.taps(lookup.footprint);
        texels += taps.size();
        lines += lines_touched(sampler, taps);
    }
    cost.texels = double(texels) / double(lookups.size());
    cost.lines = double(lines) / double(lookups.size());
}

/// The sum is kept so that no lookup can be left out.
double time_lookups(const Samplers& samplers, std::span<const Lookup> lookups) {
    glm::dvec4 sum{0};
    const double start = thread_seconds();
    for (const Lookup& lookup : lookups) sum += sampler_for(samplers, lookup).colour(lookup.footprint);
    const double seconds = thread_seconds() - start;
    const volatile double kept = sum.x + sum.y + sum.z;
    static_cast<void>(kept);
    return 1e9 * seconds / double(lookups.size());
}

}  // namespace

SourceTextures source_textures(const Scene& scene) {
    SourceTextures textures;
    for (const Material& material : scene.materials) {
        textures.emplace_back();
        if (material.base_color.image == Texture::none) continue;
        const Image& image = scene.images[std::size_t(material.base_color.image)];
        textures.back() =
            SourceTexture{texture::linear_image({image.width, image.height, image.texels, image.light}),
                          rasterizer::addressing_of(material.base_color.sampler),
                          rasterizer::surface_of(scene, material.base_color.image)};
    }
    return textures;
}

std::string sizes_of(const SourceTextures& textures) {
    std::vector<std::string> sizes;
    for (const auto& source : textures) {
        if (!source) continue;
        const std::string size = size_text(source->image.width, source->image.height);
        if (std::ranges::find(sizes, size) == sizes.end()) sizes.push_back(size);
    }
    return joined(sizes);
}

Cost cost_of(const rasterizer::Texturing& texturing, const SourceTextures& textures,
             std::span<const Lookup> lookups) {
    tbb::task_arena one_thread{1};
    const double start = thread_seconds();
    const Samplers samplers = one_thread.execute([&] { return prepared(texturing, textures); });
    Cost cost{.bytes_stored = bytes_of(samplers), .build_ms = 1e3 * (thread_seconds() - start)};
    cost.pixels = lookups.size();
    if (lookups.empty()) return cost;
    count_reads(samplers, lookups, cost);
    cost.ns_per_sample = time_lookups(samplers, lookups);
    return cost;
}

}  // namespace zproof::study
