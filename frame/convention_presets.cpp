#include "frame/convention_presets.h"

#include <array>

namespace zproof {
namespace {

constexpr auto presets = std::to_array<ConventionPreset>({
    {"pytorch3d", "id_channel=0,depth_channel=0,id_background=-1,depth_background=-1"},
    {"nvdiffrast",
     "id_channel=3,depth_channel=2,id_coding=float,id_base=1,id_background=0,rows=bottom_first,"
     "depth_kind=ndc_z,depth_background=0"},
    {"blender",
     "id_channel=ViewLayer.IndexOB.X,depth_channel=ViewLayer.Depth.Z,id_coding=float,id_base=1,"
     "id_background=0,depth_background=1e10"},
    {"open3d",
     "id_channel=0,depth_channel=0,id_background=4294967295,depth_kind=ray_length,"
     "depth_background=infinity"},
    {"mitsuba",
     "id_channel=id.I,depth_channel=depth.T,id_coding=float,background_by=depth,"
     "depth_kind=ray_length_from_near,depth_background=0"},
    {"bop", "id_channel=id,id_background=0,id_base=1,depth_coding=integer,depth_background=0"},
});

}  // namespace

std::span<const ConventionPreset> convention_presets() { return presets; }

}  // namespace zproof
