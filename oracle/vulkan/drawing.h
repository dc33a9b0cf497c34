/// A scene in a device's memory, and one picture of it.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/attributes.h"
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
    /// With vertices of their own for each triangle where their numbers tell whose they are, and with values
    /// where these are interpolated. Throws OracleError where the device cannot count that many.
    Mesh(const Device& device, const Scene& scene, const VulkanSettings& settings);
    /// All triangles by one call.
    void draw(const vk::raii::CommandBuffer& commands) const;
    /// The scene's triangle that is drawn at this place, or what a device that errs makes of it.
    std::uint32_t triangle(std::uint32_t drawn) const { return index_count_ / 3 - 1 - drawn; }

    /// What the pipeline's images of values hold that the scene has.
    const std::vector<Attribute>& attributes() const { return attributes_; }

  private:
    Mesh(const Device& device, const Scene& scene, bool own_vertices, Values values);

    std::uint32_t index_count_;
    std::vector<Attribute> attributes_;
    Buffer vertices_, index_;
};

/// As the device has them; row 0 is the top.
struct Pixels {
    Plane<std::uint32_t> id;
    Plane<double> z;  ///< in [0, 1]
    Attributes attributes{};
};

/// Draws into the pipeline's samples and gives that of the index.
Pixels draw(const Device& device, const IdPipeline& pipeline, const SampleReader& reader, const Mesh& mesh,
            const ClipRows& rows, Resolution size, int index);

}  // namespace zproof::oracle::vulkan
