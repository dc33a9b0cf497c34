/// A scene in a device's memory, and one picture of it.
#pragma once

#include <cstdint>

#include "frame/plane.h"
#include "oracle/clip_space.h"
#include "oracle/vulkan/id_pipeline.h"
#include "oracle/vulkan/memory.h"
#include "oracle/vulkan/sample_reader.h"
#include "scenes/scene.h"

namespace zproof::oracle::vulkan {

/// A scene's triangles, the last one first.
class Mesh {
  public:
    /// With vertices of their own for each triangle where their numbers tell whose they are. Throws
    /// OracleError where the device cannot count that many.
    Mesh(const Device& device, const Scene& scene, bool ids_are_of_vertices);
    /// All triangles by one call.
    void draw(const vk::raii::CommandBuffer& commands) const;
    /// The scene's triangle that is drawn at this place, or what a device that errs makes of it.
    std::uint32_t triangle(std::uint32_t drawn) const { return index_count_ / 3 - 1 - drawn; }

  private:
    std::uint32_t index_count_;
    Buffer position_world_, index_;
};

/// As the device has them; row 0 is the top.
struct Pixels {
    Plane<std::uint32_t> id;
    Plane<double> z;  ///< in [0, 1]
};

/// Draws into the pipeline's samples and gives that of the index.
Pixels draw(const Device& device, const IdPipeline& pipeline, const SampleReader& reader, const Mesh& mesh,
            const ClipRows& rows, Resolution size, int index);

}  // namespace zproof::oracle::vulkan
