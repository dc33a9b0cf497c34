#include "lessons/cost/lecture_pipeline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/processor.h"
#include "rasterizer/kernel.h"
#include "rasterizer/tile.h"

namespace zproof::study::cost {
namespace {

constexpr rasterizer::Optimizations no_optimizations{.hierarchical_z = rasterizer::HierarchicalZ::none};

void clear(Frame& frame, const rasterizer::PixelRect& pixels) {
    for (int y = pixels.y0; y < pixels.y1; ++y)
        for (int x = pixels.x0; x < pixels.x1; ++x) {
            frame.primitive.at(x, y) = PrimitiveId::none;
            frame.camera_depth.at(x, y) = background_depth;
        }
}

/// Ambient 0.1, diffuse 0.6, specular 0.3 with exponent 32; a light at infinity over the viewer's shoulder.
glm::vec3 blinn_phong(const glm::vec3& normal, const glm::vec3& toward_eye) {
    const glm::vec3 toward_light{0.36f, 0.48f, 0.8f};
    const glm::vec3 n = glm::normalize(normal);
    const glm::vec3 half = glm::normalize(toward_light + glm::normalize(toward_eye));
    const float diffuse = std::max(0.0f, glm::dot(n, toward_light));
    const float specular = std::pow(std::max(0.0f, glm::dot(n, half)), 32.0f);
    return glm::vec3(0.1f + 0.6f * diffuse + 0.3f * specular);
}

}  // namespace

std::string words_for(Stages::Set stages) {
    constexpr std::array names{"bus", "transform", "shade", "raster"};
    std::string words;
    for (unsigned i = 0; i < names.size(); ++i)
        if (stages >> i & 1) words += (words.empty() ? "" : " + ") + std::string{names[i]};
    return words;
}

LecturePipeline::LecturePipeline(const Scene& scene, const View& view)
    : scene_(scene),
      setup_(view, rasterizer::correct_rules, no_optimizations),
      eye_world_(view.camera.eye_world),
      normals_(scene.vertices.normal_world),
      bus_positions_(scene.vertices.position_world.size()),
      bus_normals_(bus_positions_.size()),
      colours_(bus_positions_.size()),
      frame_(setup_.size) {
    normals_.resize(bus_positions_.size(), glm::vec3{0, 0, 1});
}

void LecturePipeline::copy() {
    std::ranges::copy(scene_.vertices.position_world, bus_positions_.begin());
    std::ranges::copy(normals_, bus_normals_.begin());
}

void LecturePipeline::shade() {
    const auto& p = scene_.vertices.position_world;
    for (std::size_t i = 0; i < p.size(); ++i) colours_[i] = blinn_phong(normals_[i], eye_world_ - p[i]);
}

void LecturePipeline::rasterize() {
    bins_.fill(scene_, projected_, setup_);
    const rasterizer::Kernel& kernel = widest_of(rasterizer::kernels);
    for (std::size_t i = 0; i < bins_.tiles().count(); ++i) {
        const rasterizer::PixelRect pixels = bins_.tiles().pixels(i, setup_.size);
        if (bins_.entries_in(i).empty()) {
            clear(frame_, pixels);
            continue;
        }
        rasterizer::Tile tile(kernel, pixels, setup_);
        tile.draw(bins_.triangles(), {bins_.entries_in(i)});
        tile.resolve(frame_);
    }
    kernel.publish();
}

void LecturePipeline::run(Stages::Set stages) {
    if (stages & Stages::bus) copy();
    if (stages & Stages::transform) projected_.fill(scene_.vertices, setup_);
    if (stages & Stages::shade) shade();
    if (stages & Stages::raster) rasterize();
}

}  // namespace zproof::study::cost
