#include "oracle/vulkan/sample_reader.h"

#include <array>
#include <cstdint>

#include "oracle/vulkan/id_pipeline.h"
#include "oracle/vulkan/shaders/sample_shader.h"

namespace zproof::oracle::vulkan {
namespace {

using Kind = vk::DescriptorType;

constexpr std::array kinds{Kind::eSampledImage, Kind::eSampledImage, Kind::eStorageBuffer,
                           Kind::eStorageBuffer};
constexpr std::uint32_t group_side = 8;  // as in the shader

/// The push constants of oracle/vulkan/shaders/sample.comp.
struct Which {
    std::int32_t width, height, index;
};

vk::raii::DescriptorSetLayout new_set_layout(const Device& device) {
    std::array<vk::DescriptorSetLayoutBinding, kinds.size()> bindings;
    for (std::uint32_t i = 0; i < bindings.size(); ++i)
        bindings[i] = {.binding = i,
                       .descriptorType = kinds[i],
                       .descriptorCount = 1,
                       .stageFlags = vk::ShaderStageFlagBits::eCompute};
    return {device.logical(), {.bindingCount = std::uint32_t(bindings.size()), .pBindings = bindings.data()}};
}

vk::raii::PipelineLayout new_reader_layout(const Device& device, const vk::DescriptorSetLayout& set) {
    const vk::PushConstantRange which{vk::ShaderStageFlagBits::eCompute, 0, sizeof(Which)};
    return {device.logical(),
            {.setLayoutCount = 1,
             .pSetLayouts = &set,
             .pushConstantRangeCount = 1,
             .pPushConstantRanges = &which}};
}

vk::raii::Pipeline new_reader(const Device& device, const vk::PipelineLayout& layout) {
    const vk::raii::ShaderModule module = shader_module(device, sample_shader);
    const vk::ComputePipelineCreateInfo all{
        .stage = {.stage = vk::ShaderStageFlagBits::eCompute, .module = *module, .pName = "main"},
        .layout = layout};
    return {device.logical(), nullptr, all};
}

vk::raii::DescriptorPool new_descriptor_pool(const Device& device) {
    constexpr std::array sizes{vk::DescriptorPoolSize{Kind::eSampledImage, 2},
                               vk::DescriptorPoolSize{Kind::eStorageBuffer, 2}};
    return {device.logical(),
            {.flags = vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet,
             .maxSets = 1,
             .poolSizeCount = std::uint32_t(sizes.size()),
             .pPoolSizes = sizes.data()}};
}

}  // namespace

SampleReader::SampleReader(const Device& device)
    : set_layout_(new_set_layout(device)),
      layout_(new_reader_layout(device, *set_layout_)),
      pipeline_(new_reader(device, *layout_)),
      pool_(new_descriptor_pool(device)),
      sets_(device.logical(),
            {.descriptorPool = *pool_, .descriptorSetCount = 1, .pSetLayouts = &*set_layout_}) {}

void SampleReader::bind(const Device& device, const Image& ids, const Image& depths, const Buffer& id_bits,
                        const Buffer& z_bits) const {
    const std::array images{
        vk::DescriptorImageInfo{.imageView = ids.view(),
                                .imageLayout = vk::ImageLayout::eShaderReadOnlyOptimal},
        vk::DescriptorImageInfo{.imageView = depths.view(),
                                .imageLayout = vk::ImageLayout::eDepthStencilReadOnlyOptimal}};
    const std::array buffers{vk::DescriptorBufferInfo{id_bits.handle(), 0, VK_WHOLE_SIZE},
                             vk::DescriptorBufferInfo{z_bits.handle(), 0, VK_WHOLE_SIZE}};
    const std::array writes{vk::WriteDescriptorSet{.dstSet = *sets_.front(),
                                                   .dstBinding = 0,
                                                   .descriptorCount = 2,
                                                   .descriptorType = Kind::eSampledImage,
                                                   .pImageInfo = images.data()},
                            vk::WriteDescriptorSet{.dstSet = *sets_.front(),
                                                   .dstBinding = 2,
                                                   .descriptorCount = 2,
                                                   .descriptorType = Kind::eStorageBuffer,
                                                   .pBufferInfo = buffers.data()}};
    device.logical().updateDescriptorSets(writes, nullptr);
}

void SampleReader::read(const vk::raii::CommandBuffer& commands, Resolution size, int index) const {
    const auto groups = [](int side) { return (std::uint32_t(side) + group_side - 1) / group_side; };
    const vk::DescriptorSet set = *sets_.front();
    const Which which{size.width, size.height, index};
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_, 0, set, nullptr);
    commands.pushConstants<Which>(*layout_, vk::ShaderStageFlagBits::eCompute, 0, which);
    commands.dispatch(groups(size.width), groups(size.height), 1);
}

}  // namespace zproof::oracle::vulkan
