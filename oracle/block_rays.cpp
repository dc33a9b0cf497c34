#include "oracle/block_rays.h"

#include <algorithm>

#include "math/widest.h"

namespace zproof::oracle {
namespace {

constexpr int side = BlockRays::side, lanes = BlockRays::lanes;

using Axes = std::array<float*, 3>;

Axes origins_of(RTCRay16& rays) { return {rays.org_x, rays.org_y, rays.org_z}; }
Axes directions_of(RTCRay16& rays) { return {rays.dir_x, rays.dir_y, rays.dir_z}; }

/// One after another: as many as begin a block within so many pixels, filled up to whole blocks.
std::vector<double> for_each_pixel_of(int pixels, auto&& value) {
    std::vector<double> values(std::size_t(pixels / side + 1) * side);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(int(i));
    return values;
}

void add_up(const std::array<BlockRays::Coordinate, 3>& coordinates, int left, int top, const Axes& to) {
    for (std::size_t i = 0; i < 3; ++i) {
        const double* const of_column = coordinates[i].of_column.data() + left;
        const double* const of_row = coordinates[i].of_row.data() + top;
        const double last = coordinates[i].last;
        float* const sums = to[i];
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                sums[row * side + column] = float((of_column[column] + of_row[row]) + last);
    }
}

}  // namespace

BlockRays::BlockRays(const View& view)
    : any_(primary_ray(view, 0, 0)), perspective_(view.camera.projection == Projection::perspective) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const glm::dvec2 first = sampled_at(view, 0, 0);
    const glm::dvec3 direction = c.shear.x * c.right + c.shear.y * c.up - c.back;
    for (int i = 0; i < 3; ++i) {
        const double eye = c.eye_world[i];
        varying_[std::size_t(i)] = {
            .of_column = for_each_pixel_of(view.width,
                                           [&](int x) {
                                               const double u =
                                                   w.left + (w.right - w.left) * ((x + first.x) / view.width);
                                               return perspective_ ? u * c.right[i] : eye + u * c.right[i];
                                           }),
            .of_row = for_each_pixel_of(
                view.height,
                [&](int y) {
                    return (w.top - (w.top - w.bottom) * ((y + first.y) / view.height)) * c.up[i];
                }),
            .last = perspective_ ? -c.back[i] : any_.origin_depth * direction[i]};
    }
}

void BlockRays::begin(RTCRay16& rays) const {
    const Axes constant = perspective_ ? origins_of(rays) : directions_of(rays);
    const glm::vec3& values = perspective_ ? any_.origin : any_.direction;
    for (int i = 0; i < 3; ++i) std::fill_n(constant[std::size_t(i)], lanes, values[i]);
    std::fill_n(rays.tnear, lanes, any_.t_near);
    std::fill_n(rays.time, lanes, 0.0f);
    std::fill_n(rays.mask, lanes, ~0u);
    std::fill_n(rays.flags, lanes, 0u);
    for (int lane = 0; lane < lanes; ++lane) rays.id[lane] = unsigned(lane);
}

void BlockRays::aim(int left, int top, RTCRay16& rays) const {
    widest<add_up>(varying_, left, top, perspective_ ? directions_of(rays) : origins_of(rays));
    std::fill_n(rays.tfar, lanes, any_.t_far);
}

}  // namespace zproof::oracle
