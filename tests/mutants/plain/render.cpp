#include "tests/mutants/plain/render.h"

#include "tests/mutants/plain/methods.h"

namespace plain {
namespace {

constexpr std::array all_modes{
    Mode{"tiled", "raster,origin=eye,clipping=view_volume",
         [](const Mesh& mesh, const Camera& camera) {
             return draw_tiled(mesh, camera, DepthBuffer::camera_depth);
         }},
    Mode{"tiled_reversed_z",
         "raster,origin=eye,clipping=view_volume,depth_buffer=reversed_z,depth_interpolation=barycentrics",
         [](const Mesh& mesh, const Camera& camera) {
             return draw_tiled(mesh, camera, DepthBuffer::reversed_z);
         }},
    Mode{"tiled_z24",
         "raster,origin=eye,clipping=view_volume,depth_buffer=standard_z,depth_format=unorm24,"
         "depth_interpolation=barycentrics",
         [](const Mesh& mesh, const Camera& camera) {
             return draw_tiled(mesh, camera, DepthBuffer::standard_z24);
         }},
    Mode{"unsnapped",
         "raster,transform=float64,origin=eye,snap=none,edge_functions=from_corner,edge_arithmetic=float64,"
         "clipping=view_volume,interpolation=float64",
         draw_unsnapped},
    Mode{"homogeneous",
         "raster,transform=float64,origin=eye,snap=none,edge_functions=homogeneous,edge_arithmetic=float64,"
         "interpolation=float64",
         draw_homogeneous},
    Mode{"pluecker", "ray", cast_pluecker},
    Mode{"moeller_trumbore", "ray,arithmetic=float64,test=moeller_trumbore", cast_moeller_trumbore},
};

}  // namespace

std::span<const Mode> modes() { return all_modes; }

}  // namespace plain
