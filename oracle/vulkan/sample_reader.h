/// Reads one sample of a multisampled target, which no copy does, by a compute shader.
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include "frame/plane.h"
#include "oracle/vulkan/memory.h"

namespace zproof::oracle::vulkan {

class SampleReader {
  public:
    explicit SampleReader(const Device& device);

    /// Where what is read comes from, and where it goes: a uint32 and the bits of a float per pixel. They are
    /// bound until the next call, so what is recorded must be done by then.
    void bind(const Device& device, const Image& ids, const Image& depths, const Buffer& id_bits,
              const Buffer& z_bits) const;
    void read(const vk::raii::CommandBuffer& commands, Resolution size, int index) const;

  private:
    vk::raii::DescriptorSetLayout set_layout_;
    vk::raii::PipelineLayout layout_;
    vk::raii::Pipeline pipeline_;
    vk::raii::DescriptorPool pool_;
    vk::raii::DescriptorSets sets_;
};

}  // namespace zproof::oracle::vulkan
