#include "oracle/vulkan/id_pipeline.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "oracle/vulkan/shaders/fragment_shader.h"
#include "oracle/vulkan/shaders/fragment_shader_with_attributes.h"
#include "oracle/vulkan/shaders/fragment_shader_with_vertex_id.h"
#include "oracle/vulkan/shaders/vertex_shader.h"
#include "oracle/vulkan/shaders/vertex_shader_with_attributes.h"
#include "oracle/vulkan/shaders/vertex_shader_with_id.h"

namespace zproof::oracle::vulkan {
namespace {

using Access = vk::AccessFlagBits;
using Stage = vk::PipelineStageFlagBits;

vk::AttachmentDescription attachment(vk::Format format, vk::SampleCountFlagBits samples,
                                     vk::ImageLayout afterwards) {
    return {.format = format,
            .samples = samples,
            .loadOp = vk::AttachmentLoadOp::eClear,
            .storeOp = vk::AttachmentStoreOp::eStore,
            .stencilLoadOp = vk::AttachmentLoadOp::eDontCare,
            .stencilStoreOp = vk::AttachmentStoreOp::eDontCare,
            .initialLayout = vk::ImageLayout::eUndefined,
            .finalLayout = afterwards};
}

/// Clears all images, draws, and leaves them to be copied, or to be read by a shader where they have several
/// samples. Depth is the first, ids the second, values the others.
vk::raii::RenderPass new_pass(const Device& device, vk::Format depth, vk::SampleCountFlagBits samples,
                              int values) {
    using Layout = vk::ImageLayout;
    const bool copied = samples == vk::SampleCountFlagBits::e1;
    std::vector attachments{
        attachment(depth, samples,
                   copied ? Layout::eTransferSrcOptimal : Layout::eDepthStencilReadOnlyOptimal),
        attachment(id_format, samples,
                   copied ? Layout::eTransferSrcOptimal : Layout::eShaderReadOnlyOptimal)};
    attachments.resize(attachments.size() + std::size_t(values),
                       attachment(value_format, samples, Layout::eTransferSrcOptimal));
    const vk::AttachmentReference z{0, Layout::eDepthStencilAttachmentOptimal};
    std::vector<vk::AttachmentReference> colours;
    for (std::uint32_t i = 1; i < attachments.size(); ++i)
        colours.push_back({i, Layout::eColorAttachmentOptimal});
    const vk::SubpassDescription drawing{.pipelineBindPoint = vk::PipelineBindPoint::eGraphics,
                                         .colorAttachmentCount = std::uint32_t(colours.size()),
                                         .pColorAttachments = colours.data(),
                                         .pDepthStencilAttachment = &z};
    const vk::SubpassDependency read_afterwards{
        .srcSubpass = 0,
        .dstSubpass = VK_SUBPASS_EXTERNAL,
        .srcStageMask = Stage::eColorAttachmentOutput | Stage::eLateFragmentTests,
        .dstStageMask = Stage::eTransfer | Stage::eComputeShader,
        .srcAccessMask = Access::eColorAttachmentWrite | Access::eDepthStencilAttachmentWrite,
        .dstAccessMask = Access::eTransferRead | Access::eShaderRead};
    return {device.logical(),
            {.attachmentCount = std::uint32_t(attachments.size()),
             .pAttachments = attachments.data(),
             .subpassCount = 1,
             .pSubpasses = &drawing,
             .dependencyCount = 1,
             .pDependencies = &read_afterwards}};
}

vk::raii::PipelineLayout new_layout(const Device& device) {
    const vk::PushConstantRange rows{vk::ShaderStageFlagBits::eVertex, 0, sizeof(ClipRowsPushed)};
    return {device.logical(), {.pushConstantRangeCount = 1, .pPushConstantRanges = &rows}};
}

vk::PipelineShaderStageCreateInfo stage(vk::ShaderStageFlagBits which, const vk::raii::ShaderModule& module) {
    return {.stage = which, .module = *module, .pName = "main"};
}

vk::PipelineDepthStencilStateCreateInfo depth_test(DepthBuffer buffer) {
    return {.depthTestEnable = true,
            .depthWriteEnable = true,
            .depthCompareOp = buffer == DepthBuffer::reversed_z ? vk::CompareOp::eGreaterOrEqual
                                                                : vk::CompareOp::eLessOrEqual};
}

struct Shaders {
    vk::raii::ShaderModule vertex, fragment;
};

Shaders shaders_for(const Device& device, const VulkanSettings& settings) {
    if (settings.attributes == Values::all)
        return {shader_module(device, vertex_shader_with_attributes),
                shader_module(device, fragment_shader_with_attributes)};
    if (ids_are_of_vertices(device, settings))
        return {shader_module(device, vertex_shader_with_id),
                shader_module(device, fragment_shader_with_vertex_id)};
    return {shader_module(device, vertex_shader), shader_module(device, fragment_shader)};
}

/// All that does not change from one pipeline to the next is said here.
vk::raii::Pipeline new_pipeline(const Device& device, const VulkanSettings& settings,
                                vk::SampleCountFlagBits samples, const vk::raii::RenderPass& pass,
                                const vk::raii::PipelineLayout& layout) {
    const bool with_values = settings.attributes == Values::all;
    const auto [vertex, fragment] = shaders_for(device, settings);
    const std::array stages{stage(vk::ShaderStageFlagBits::eVertex, vertex),
                            stage(vk::ShaderStageFlagBits::eFragment, fragment)};
    const vk::VertexInputBindingDescription corners{
        0, std::uint32_t(with_values ? sizeof(VertexValues) : sizeof(glm::vec3)),
        vk::VertexInputRate::eVertex};
    constexpr std::array<vk::VertexInputAttributeDescription, 3> of_vertex{
        {{0, 0, vk::Format::eR32G32B32Sfloat, offsetof(VertexValues, p_world)},
         {1, 0, vk::Format::eR32G32Sfloat, offsetof(VertexValues, uv)},
         {2, 0, vk::Format::eR32G32B32Sfloat, offsetof(VertexValues, normal_world)}}};
    const vk::PipelineVertexInputStateCreateInfo input{
        .vertexBindingDescriptionCount = 1,
        .pVertexBindingDescriptions = &corners,
        .vertexAttributeDescriptionCount = with_values ? std::uint32_t(of_vertex.size()) : 1,
        .pVertexAttributeDescriptions = of_vertex.data()};
    const vk::PipelineInputAssemblyStateCreateInfo triangles{.topology =
                                                                 vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo rasterizer{
        .depthClampEnable = settings.planes == PlanesBy::distances,
        .cullMode = vk::CullModeFlagBits::eNone,
        .lineWidth = 1};
    const vk::PipelineMultisampleStateCreateInfo multisample{.rasterizationSamples = samples};
    const vk::PipelineDepthStencilStateCreateInfo depth = depth_test(settings.depth_buffer);
    using Component = vk::ColorComponentFlagBits;
    const std::vector<vk::PipelineColorBlendAttachmentState> written(
        with_values ? 1 + value_images : 1,
        {.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA});
    const vk::PipelineColorBlendStateCreateInfo unblended{.attachmentCount = std::uint32_t(written.size()),
                                                          .pAttachments = written.data()};
    constexpr std::array set_later{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = std::uint32_t(set_later.size()),
                                                     .pDynamicStates = set_later.data()};
    const vk::GraphicsPipelineCreateInfo all{.stageCount = std::uint32_t(stages.size()),
                                             .pStages = stages.data(),
                                             .pVertexInputState = &input,
                                             .pInputAssemblyState = &triangles,
                                             .pViewportState = &viewport,
                                             .pRasterizationState = &rasterizer,
                                             .pMultisampleState = &multisample,
                                             .pDepthStencilState = &depth,
                                             .pColorBlendState = &unblended,
                                             .pDynamicState = &dynamic,
                                             .layout = *layout,
                                             .renderPass = *pass};
    return {device.logical(), nullptr, all};
}

}  // namespace

bool ids_are_of_vertices(const Device& device, const VulkanSettings& settings) {
    if (settings.attributes == Values::all) return true;
    if (settings.ids == IdSource::as_there_is) return !device.physical().getFeatures().geometryShader;
    return settings.ids == IdSource::vertex;
}

vk::raii::ShaderModule shader_module(const Device& device, std::span<const std::uint32_t> code) {
    return {device.logical(), {.codeSize = code.size_bytes(), .pCode = code.data()}};
}

IdPipeline::IdPipeline(const Device& device, const VulkanSettings& settings, vk::SampleCountFlagBits samples)
    : samples_(samples),
      depth_format_(format_of(device.physical(), settings.depth_format)),
      farthest_z_(settings.depth_buffer == DepthBuffer::reversed_z ? 0 : 1),
      values_(settings.attributes == Values::all ? value_images : 0),
      pass_(new_pass(device, depth_format_, samples, values_)),
      layout_(new_layout(device)),
      pipeline_(new_pipeline(device, settings, samples, pass_, layout_)) {}

void IdPipeline::bind(const vk::raii::CommandBuffer& commands, const vk::Extent2D& size,
                      const ClipRowsPushed& rows) const {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    const vk::Viewport viewport{0, 0, float(size.width), float(size.height), 0, 1};
    const vk::Rect2D scissor{{0, 0}, size};
    commands.setViewport(0, viewport);
    commands.setScissor(0, scissor);
    commands.pushConstants<ClipRowsPushed>(*layout_, vk::ShaderStageFlagBits::eVertex, 0, rows);
}

}  // namespace zproof::oracle::vulkan
