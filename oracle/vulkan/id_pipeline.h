/// The fixed part of drawing: what is drawn into, the shaders, the rasterizer's state.
#pragma once

#include <glm/glm.hpp>
#include <vulkan/vulkan_raii.hpp>

#include "oracle/vulkan/device.h"

namespace zproof::oracle::vulkan {

inline constexpr vk::Format id_format = vk::Format::eR32Uint, value_format = vk::Format::eR32G32B32A32Sfloat;

/// Images of four floats: barycentrics and uv, the normal, the position.
inline constexpr int value_images = 3;

/// A vertex as the pipeline with attributes reads it; without, the place alone.
struct VertexValues {
    glm::vec3 p_world;
    glm::vec2 uv;
    glm::vec3 normal_world;
};

/// The push constants of oracle/vulkan/shaders/ids.vert.
struct ClipRowsPushed {
    glm::vec4 x, y, z, w, near_distance, far_distance, eye_world;
};

/// Both faces, nearest stays, of equal depths the one that is drawn last; nothing is blended.
class IdPipeline {
  public:
    IdPipeline(const Device& device, const VulkanSettings& settings, vk::SampleCountFlagBits samples);

    const vk::RenderPass& pass() const { return *pass_; }
    vk::SampleCountFlagBits samples() const { return samples_; }
    vk::Format depth_format() const { return depth_format_; }
    float farthest_z() const { return farthest_z_; }  ///< where nothing is drawn
    int values() const { return values_; }            ///< images of values beside the ids
    /// The viewport is the whole image.
    void bind(const vk::raii::CommandBuffer& commands, const vk::Extent2D& size,
              const ClipRowsPushed& rows) const;

  private:
    vk::SampleCountFlagBits samples_;
    vk::Format depth_format_;
    float farthest_z_;
    int values_;
    vk::raii::RenderPass pass_;
    vk::raii::PipelineLayout layout_;
    vk::raii::Pipeline pipeline_;
};

/// Does the vertex shader say whose triangle it is?
bool ids_are_of_vertices(const Device& device, const VulkanSettings& settings);

/// A shader's code for the device.
vk::raii::ShaderModule shader_module(const Device& device, std::span<const std::uint32_t> code);

}  // namespace zproof::oracle::vulkan
